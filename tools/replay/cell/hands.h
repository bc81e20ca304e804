#pragma once

#include <memory>

#include "haptic_station/device/trial.h"
#include "haptic_station/ports/rig.h"
#include "tools/replay/scenario/scenario.h"
#include "tools/replay/source/recorded_hand.h"

namespace telepalp::replay {

/// A simulated person at a simulated device who repeats `script`. `trial`: the scene's. `seed`: of the tracker's noise.
[[nodiscard]] std::unique_ptr<ports::Rig> scripted_hand(HandScript script, device::Trial trial, std::uint64_t seed);

/// A device and a hand that follow a recorded motion; the force does not move them. Before the recording they rest at
/// its first position, after it at its last one. `recorded` is not empty and outlives the returned object.
[[nodiscard]] std::unique_ptr<ports::Rig> recorded_hand(const RecordedHand& recorded);

}  // namespace telepalp::replay
