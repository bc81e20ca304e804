#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptic_station/loop/compensation.h"
#include "haptic_station/loop/tick_sample.h"
#include "messages/station.pb.h"

namespace telepalp::core {

/// The message of the topic /station/state for one tick.
[[nodiscard]] msg::StationState state_message(const loop::TickSample& sample);

/// The message of the topic /station/compensation.
[[nodiscard]] msg::StationCompensation compensation_message(const loop::Compensation& compensation);

/// The message of the topic /station/events for a phase change at this tick. `from`: the phase before; 0 at the first
/// tick.
[[nodiscard]] msg::StationEvent phase_event(const loop::TickSample& sample, std::uint8_t from);

/// The message of the topic /station/events for a fault. `first`: the first tick in the phase Faulted.
[[nodiscard]] msg::StationEvent fault_event(const loop::TickSample& first);

/// The parts of `samples` that follow one another at the period loop::kTickPeriod. A thread that was late by a whole
/// period skips it, and there a new part begins.
[[nodiscard]] std::vector<std::span<const loop::TickSample>> unbroken_runs(std::span<const loop::TickSample> samples);

/// One message of the topic /station/ticks: an unbroken run of ticks, not empty. A reader computes the time of each
/// tick from that of the first one.
[[nodiscard]] msg::StationTicks ticks_message(std::span<const loop::TickSample> samples);

}  // namespace telepalp::core
