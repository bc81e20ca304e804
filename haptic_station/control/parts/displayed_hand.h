#pragma once

#include "haptic_station/control/values/control_input.h"
#include "proto/words/last_result.h"

namespace telepalp::control {

/// Computes where the viewer draws the hand (paper S1 II.E, docs/sources.md). While the hand is in the body, it is
/// drawn at the proxy; otherwise at the tracked position. When the hand enters or leaves the body, the offset between
/// the two decays exponentially, so that the drawn hand does not jump. Owner: haptic thread.
class DisplayedHand {
 public:
  /// `fade_s`: time constant with which the offset between proxy and tracked position decays.
  explicit DisplayedHand(double fade_s) noexcept : fade_s_(fade_s) {}

  /// Computes one tick. `inside`: the hand is in the body. `contact`: contact with the displayed skin.
  [[nodiscard]] Point<HapticBase> step(const ControlInput& in, const ports::SurfaceContact& contact, bool inside,
                                       double dt_s) noexcept;

 private:
  double fade_s_;
  Point<HapticBase> at_;
  Point<HapticBase> last_proxy_;
  Eigen::Vector3d offset_m_ = Eigen::Vector3d::Zero();
  bool inside_ = false;
  LastExp left_;  ///< share of the offset that is left after a tick
};

}  // namespace telepalp::control
