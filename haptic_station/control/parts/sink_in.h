#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::control {

/// Handles a contact that begins below the skin, because the skin rose or the station was not ready. The hand has done
/// no work to reach that depth. The whole body, with the objects inside, is therefore displayed lower by that depth,
/// along the skin's normal, and rises to its true place. The displayed surface also moves towards the measured one.
/// Both rises together are 100 mm/s or less; with a gap between skin and end-effector, 150 mm/s or less. When the
/// contact's coverage grows, for example because the camera sees the skin again, the body is lowered so far that the
/// indentation times the coverage stays the same: otherwise a skin that stiffens under a deep hand would give the hand
/// energy. Owner: haptic thread.
class SinkIn {
 public:
  /// Begins a contact. `contact`: the contact with the body at its true place, where it is not lowered.
  void begin(const ports::SurfaceContact& contact) noexcept;
  /// Lowers the displayed body if the coverage has grown, and lets the body rise towards its true place for one tick.
  /// `contact`: as in begin().
  void step(const ports::SurfaceContact& contact, double dt_s) noexcept;

  /// How far the last step lowered the displayed body because the coverage grew [m]; this does no work on the hand.
  [[nodiscard]] double sank_m() const noexcept { return sank_m_; }

  /// `contact`, converted to the contact with the lowered body.
  [[nodiscard]] ports::SurfaceContact shown(const ports::SurfaceContact& contact) const noexcept;

  /// The input of the effects, relative to the lowered body: the body is at its true place, and the device is raised by
  /// as much as the body is lowered. `as_shown`: the result of shown(). A contact that begins inside an inner object
  /// thus does not start with elastic energy that the hand never supplied.
  [[nodiscard]] effects::EffectInput in_body_frame(const Point<HapticBase>& device, const Vector<HapticBase>& velocity,
                                                   const ports::SurfaceContact& as_shown) const noexcept;

 private:
  double lowered_m_ = 0.0;       ///< how much lower the displayed body lies than the true one
  double rising_m_per_s_ = 0.0;  ///< speed of the displayed body towards its true place
  double sank_m_ = 0.0;
  double coverage_ = 0.0;  ///< of the contact at the last step
};

}  // namespace telepalp::control
