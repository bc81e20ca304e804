#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::control {

/// A contact that begins at some depth: the skin came up, or the station was not ready. The hand has done no work for
/// that depth, so the body is shown lower by it, with everything inside, and then rises slowly to where it belongs, as
/// a patient's would. Owner: control thread.
class SinkIn {
 public:
  /// Contact begins `depth_m` below the skin.
  void begin(double depth_m) noexcept;
  /// One tick: the shown body rises.
  void step(double dt_s) noexcept;

  /// The contact with the body as shown.
  [[nodiscard]] ports::SurfaceContact shown(const ports::SurfaceContact& contact) const noexcept;

  /// What the effects may know, in the body's own frame: the device is seen from a body that is not shown lower, so
  /// that a contact which begins within an inner object does not release that object's energy.
  [[nodiscard]] effects::EffectInput in_body_frame(const Point<HapticBase>& device, const Vector<HapticBase>& velocity,
                                                   const ports::SurfaceContact& as_shown) const noexcept;

 private:
  double lowered_m_ = 0.0;       ///< the shown body lies so much lower than the true one
  double rising_m_per_s_ = 0.0;  ///< of the shown body
};

}  // namespace telepalp::control
