#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptic_station/effects/effect_bank.h"
#include "messages/station.pb.h"

namespace telepalp::station {

/// The processor's time-stamp counter on x86-64, else the steady clock [ns]: a clock without a system call, to measure
/// the cost of effects.
[[nodiscard]] std::uint64_t cycles_now() noexcept;

/// Counts of cycles_now() per microsecond. The first call measures them against the steady clock and blocks for 10 ms.
[[nodiscard]] double cycles_per_us();

/// Computing time of each effect since the station started, in counts of cycles_now(): a copy that the haptic thread
/// gives to the network thread.
struct Bill {
  std::array<effects::EffectBill, effects::EffectBank::kMostEffects> lines{};
  std::size_t count = 0;
};

[[nodiscard]] Bill bill_of(const effects::EffectBank& effects) noexcept;

/// Mean and largest cost of each effect per tick in microseconds, as messages.
[[nodiscard]] std::vector<msg::EffectCost> costs_of(const Bill& bill, double cycles_per_us);

/// The mean costs in one line: `skin 0.40 us, cylinder 0.10 us, total 0.50 us of the 500.00 us of a tick`.
[[nodiscard]] std::string line_of(const std::vector<msg::EffectCost>& costs, double tick_us);

}  // namespace telepalp::station
