#pragma once

#include "haptic_station/control/values/control_input.h"

namespace telepalp::control {

/// Where the viewer draws the hand (S1 II.E): in the body at the proxy, outside the body where it is tracked. When the
/// hand enters or leaves the body, the distance between the two places fades instead of showing as a jump. Owner:
/// control thread.
class DisplayedHand {
 public:
  /// `fade_s`: time constant with which that distance fades.
  explicit DisplayedHand(double fade_s) noexcept : fade_s_(fade_s) {}

  /// One tick. `inside`: the hand is in the body. `contact`: the contact as the hand feels it.
  [[nodiscard]] Point<HapticBase> step(const ControlInput& in, const ports::SurfaceContact& contact, bool inside,
                                       double dt_s) noexcept;

 private:
  double fade_s_;
  Point<HapticBase> at_;
  Point<HapticBase> last_proxy_;
  Eigen::Vector3d offset_m_ = Eigen::Vector3d::Zero();
  bool inside_ = false;
};

}  // namespace telepalp::control
