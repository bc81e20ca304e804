#pragma once

#include "haptic_station/control/values/encountered_settings.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::control {

/// The horizontal plane above the body on which the free end-effector waits (S1 II.D). It keeps its clearance from the
/// skin below the end-effector and moves at a bounded speed. Owner: control thread.
class WaitingPlane {
 public:
  explicit WaitingPlane(const PlaneSettings& settings) noexcept : settings_(settings) {}

  /// One tick. At the first tick the plane takes its place at once; later it moves at the bounded speed.
  void move(const Point<HapticBase>& device, const ports::SurfaceContact& contact, double dt_s) noexcept;

  [[nodiscard]] double height_m() const noexcept { return height_m_; }
  /// Height at which the end-effector is held: S1 eq. (5) adds delta_o.
  [[nodiscard]] double target_height_m() const noexcept { return height_m_ + settings_.offset_m; }

 private:
  PlaneSettings settings_;
  double height_m_ = 0.0;
  bool placed_ = false;
};

}  // namespace telepalp::control
