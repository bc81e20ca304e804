#pragma once

#include "haptic_station/control/values/control_input.h"

namespace telepalp::control {

/// Where the viewer draws the hand (S1 II.E): on the proxy in the body, as tracked out of it. The difference at a
/// change between the two fades. Owner: control thread.
class DisplayedHand {
 public:
  /// `fade_s`: time constant of the fading difference.
  explicit DisplayedHand(double fade_s) noexcept : fade_s_(fade_s) {}

  /// One tick, in the body (`inside`) or out of it. `contact`: as the hand feels it.
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
