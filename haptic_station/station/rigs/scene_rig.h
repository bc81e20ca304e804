#pragma once

#include <memory>
#include <optional>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/ports/rig.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/tracking/hand_trace.h"

namespace telepalp::station {

/// The haptic loop of a scene, with the scene's effects. It measures the computing time of each effect.
[[nodiscard]] loop::HapticLoop loop_of(const scenes::Scene& scene, const effects::EffectBank& effects);

/// The simulated device, hand and tracker of a scene: the hand carries out the scene's trial, or repeats `trace` when
/// there is one.
[[nodiscard]] std::unique_ptr<ports::Rig> rig_of(const scenes::Scene& scene,
                                                 const std::optional<tracking::HandTrace>& trace);

}  // namespace telepalp::station
