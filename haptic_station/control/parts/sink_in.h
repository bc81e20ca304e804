#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::control {

/// Handles a contact that begins below the skin, because the skin rose or the station was not ready. The hand has done
/// no work to reach that depth. The whole body, with the objects inside, is therefore displayed lower by that depth,
/// along the skin's normal, and rises to its true place at 50 mm/s or less. Owner: haptic thread.
class SinkIn {
 public:
  /// Contact begins `depth_m` below the skin.
  void begin(double depth_m) noexcept;
  /// Lets the displayed body rise towards its true place for one tick.
  void step(double dt_s) noexcept;

  /// `contact`, converted to the contact with the lowered body.
  [[nodiscard]] ports::SurfaceContact shown(const ports::SurfaceContact& contact) const noexcept;

  /// The input of the effects, relative to the lowered body: the body is at its true place, and the device is raised by
  /// as much as the body is lowered. `as_shown`: the result of shown(). A contact that begins inside an inner object
  /// thus does not start with elastic energy that the hand never supplied.
  [[nodiscard]] effects::EffectInput in_body_frame(const Point<HapticBase>& device, const Vector<HapticBase>& velocity,
                                                   const ports::SurfaceContact& as_shown) const noexcept;

 private:
  double lowered_m_ = 0.0;       ///< how much lower the displayed body lies than the true one
  double rising_m_per_s_ = 0.0;  ///< speed of the displayed body
};

}  // namespace telepalp::control
