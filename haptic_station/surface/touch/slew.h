#pragma once

#include <Eigen/Core>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// How fast a new snapshot takes over from the old one.
struct SlewSettings {
  double least_s = 0.033;  ///< one frame of a 30 Hz camera: never faster
  double most_s = 2.0;
  double speed_m_per_s = 0.03;  ///< of the surface under the proxy: 7.5 mN a tick at 500 N/m
  double turn_rad_per_s = 0.5;  ///< of its normal
  double reach_m = 0.08;        ///< beyond this from the proxy the new snapshot counts at once
};

/// What the displayed surface still differs by from the newest snapshot: an offset and a tilt around the proxy's place
/// at the swap, dying away. Plain data, so the older snapshot need not be kept alive, and the cost of a step is the
/// same with or without a swap.
class Slew {
 public:
  /// Adds what is left of the difference to a raw sample at `query`.
  [[nodiscard]] FieldSample shown(const FieldSample& raw, const Eigen::Vector3d& query) const noexcept;

  /// From now on the difference is `old_shown − fresh`, both taken at `at`.
  void begin(const FieldSample& old_shown, const FieldSample& fresh, const Eigen::Vector3d& at,
             const SlewSettings& settings) noexcept;
  /// The same from a bare offset: the displayed surface lies `offset_m` below the true one until it has caught up.
  void begin(double offset_m, const Eigen::Vector3d& tilt, const Eigen::Vector3d& at,
             const SlewSettings& settings) noexcept;
  void advance(double dt_s) noexcept;
  void stop() noexcept { left_s_ = 0.0; }

  /// Speed at which the slew itself moves the displayed surface outwards [m/s].
  [[nodiscard]] double velocity_m_per_s() const noexcept;
  [[nodiscard]] bool active() const noexcept { return left_s_ > 0.0; }

 private:
  [[nodiscard]] double share() const noexcept;

  Eigen::Vector3d at_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d tilt_ = Eigen::Vector3d::Zero();
  double offset_m_ = 0.0;
  double lasts_s_ = 0.033;
  double left_s_ = 0.0;
  double reach_m_ = 0.08;
};

}  // namespace telepalp::surface
