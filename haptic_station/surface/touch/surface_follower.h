#pragma once

#include <Eigen/Core>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// How the displayed surface may move towards the newest one.
struct FollowLimits {
  double bandwidth_rad_per_s = 40.0;  ///< of the critically damped approach to what is near
  double speed_m_per_s = 0.05;        ///< of the approach, on top of the surface's own motion
  double acceleration_m_per_s2 = 1.5;
  double fastest_surface_m_per_s = 0.3;  ///< of the surface's own motion that is believed
};

/// One step of a critically damped approach with bounded speed and acceleration. `error`: target less value;
/// `target_rate`: of the target. Returns the next rate of the value. It depends on the present error and rate alone, so
/// a target that is told anew ten or 200 times a second is followed alike.
[[nodiscard]] Eigen::Vector3d next_rate(const Eigen::Vector3d& rate, const Eigen::Vector3d& error,
                                        const Eigen::Vector3d& target_rate, const FollowLimits& limits,
                                        double dt_s) noexcept;

/// The displayed surface: the newest one, translated and tilted by a lag that dies away. Position, normal and speed of
/// what is displayed stay continuous when a newer snapshot takes over. The newest surface is evaluated on itself and
/// not where the displayed one is, so a lag may be larger than the gate between two surfaces. Plain data: the older
/// snapshot need not be kept alive. Owner: the haptic thread.
class SurfaceFollower {
 public:
  explicit SurfaceFollower(const FollowLimits& limits) noexcept : limits_(limits) {}

  /// Where the newest surface has what is displayed at `shown`.
  [[nodiscard]] Eigen::Vector3d on_newest(const Eigen::Vector3d& shown) const noexcept;
  /// The displayed sample at `at`, of the newest one at on_newest(at).
  [[nodiscard]] FieldSample shown(const FieldSample& newest) const noexcept;

  /// Displays the newest surface as it is, moving at `speed_m_per_s` along `normal`.
  void follow_at_once(const Eigen::Vector3d& normal, double speed_m_per_s) noexcept;
  /// A newer surface takes over: what is displayed at `foot` with `normal` is the newest surface's `there`, with
  /// `newest_normal`. Neither place, normal nor speed of what is displayed changes.
  void take_over(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal, const Eigen::Vector3d& there,
                 const Eigen::Vector3d& newest_normal) noexcept;
  /// `dt_s` later: the newest surface has moved at `newest_speed_m_per_s` along `normal` at `foot`.
  void advance(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal, double newest_speed_m_per_s,
               double dt_s) noexcept;

  /// From the displayed foot to the same place of the newest surface.
  [[nodiscard]] const Eigen::Vector3d& lag_m() const noexcept { return lag_m_; }
  [[nodiscard]] const Eigen::Vector3d& velocity_m_per_s() const noexcept { return velocity_m_per_s_; }

 private:
  void turn_about(const Eigen::Vector3d& pivot) noexcept;

  FollowLimits limits_;
  Eigen::Vector3d pivot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d lag_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_per_s_ = Eigen::Vector3d::Zero();  ///< of the displayed surface, at the pivot
  Eigen::Vector3d tilt_rad_ = Eigen::Vector3d::Zero();          ///< from displayed to newest, about the pivot
  Eigen::Vector3d turn_rad_per_s_ = Eigen::Vector3d::Zero();    ///< of the displayed surface
};

/// How far a line's crossing with the surface has risen: the displayed skin at one place while the device is elsewhere.
/// Owner: the haptic thread.
class LineFollower {
 public:
  explicit LineFollower(const FollowLimits& limits) noexcept : limits_(limits) {}

  /// Begins at `at`, moving along `along` (unit) at `rate_m_per_s`.
  void begin(const Eigen::Vector3d& at, const Eigen::Vector3d& along, double rate_m_per_s) noexcept;
  /// Towards `error_m` farther up the line, where the newest surface is and moves at `target_m_per_s`.
  void advance(double error_m, double target_m_per_s, double dt_s) noexcept;

  [[nodiscard]] Eigen::Vector3d at() const noexcept { return start_ + risen_m_ * along_; }
  [[nodiscard]] const Eigen::Vector3d& along() const noexcept { return along_; }
  [[nodiscard]] double rate_m_per_s() const noexcept { return rate_m_per_s_; }

 private:
  FollowLimits limits_;
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_ = Eigen::Vector3d::UnitZ();
  double risen_m_ = 0.0;
  double rate_m_per_s_ = 0.0;
};

}  // namespace telepalp::surface
