#pragma once

#include <algorithm>
#include <optional>

#include "haptic_station/control/values/encountered_settings.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::control {

/// The horizontal plane above the body on which the free end-effector waits (paper S1 II.D, docs/sources.md). It stays
/// at least PlaneSettings::clearance_m above the skin below the end-effector, as far as its bounded speed allows.
/// Heights are y in H, the haptic base's frame. Owner: haptic thread.
class WaitingPlane {
 public:
  explicit WaitingPlane(const PlaneSettings& settings) noexcept : settings_(settings) {}

  /// Moves the plane for one tick, to the skin's height plus the clearance, but at least to PlaneSettings::height_m;
  /// without a skin, to height_m. The first call sets it at once; later calls move it by at most speed_m_per_s * dt_s.
  /// `wait_at_m`: a browser's hand demands that the end-effector waits at this height instead; it moves twice as fast.
  /// The plane is then 2 cm lower, so that an end-effector that lags behind its target is not below the plane, which
  /// would end its control.
  void move(const Point<HapticBase>& device, const ports::SurfaceContact& contact,
            const std::optional<double>& wait_at_m, double dt_s) noexcept;

  [[nodiscard]] double height_m() const noexcept { return height_m_; }
  /// Height at which position control holds the end-effector: the plane's height plus delta_o of S1 eq. (5), or the
  /// demanded height.
  [[nodiscard]] double target_height_m() const noexcept { return std::max(height_m_, raised_m_) + settings_.offset_m; }

 private:
  PlaneSettings settings_;
  double height_m_ = 0.0;
  double raised_m_ = 0.0;  ///< the height that `wait_at_m` demands; height_m_ without a demand
  bool placed_ = false;
};

}  // namespace telepalp::control
