#pragma once

#include <limits>
#include <optional>

#include "haptic_station/effects/laws/skin_law.h"
#include "haptic_station/scenes/scene.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "tools/replay/cell/replayed_station.h"

namespace telepalp::replay {

inline constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// The values of one tick from which the figures are computed.
struct TickRecord {
  Eigen::Vector3f force_N = Eigen::Vector3f::Zero();   ///< in the haptic base's frame H
  Eigen::Vector3d device_m = Eigen::Vector3d::Zero();  ///< true position in H
  control::Phase phase = control::Phase::Released;
  bool touching = false;           ///< is_inside(phase) or Body to plane, and the device is in the displayed body
  bool felt = false;               ///< the controller displays the skin or an object in it
  float depth_m = kUnknown;        ///< of the device below the true skin; negative: outside
  float off_truth_N = kUnknown;    ///< along the true normal: displayed force minus the true skin's
  float law_N = kUnknown;          ///< magnitude of the force that the true skin would give, at most the peak
  float surface_off_m = kUnknown;  ///< device's distance to the displayed surface minus its distance to the true one
  float surface_age_s = kUnknown;
  float passivity_J = 0.0F;    ///< energy taken from the hand less energy stored; below 0: active
  float hand_excess_J = 0.0F;  ///< work on the hand in this contact beyond the measured skin's
};

/// Compares a tick with the true skin of the same instant. `surface`: nullopt: unknown. `law`: force law of the skin;
/// nullptr: the scene has no skin. `peak_N`: upper bound of the law's force. The force at an object inside the body is
/// not compared, because the law covers only the skin.
[[nodiscard]] TickRecord judged(const TickOutcome& tick, const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                                const std::optional<capture::TrueSurface>& surface, const effects::SkinLaw* law,
                                double peak_N);

}  // namespace telepalp::replay
