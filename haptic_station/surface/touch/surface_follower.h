#pragma once

#include <Eigen/Core>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "proto/words/last_result.h"

namespace telepalp::surface {

/// Limits of the approach of the displayed surface, which the hand feels, to the newest one.
struct FollowLimits {
  double speed_m_per_s = 0.05;  ///< greatest speed of the approach, in addition to the surface's own motion
  double acceleration_m_per_s2 = 1.5;
  double speed_in_gap_m_per_s = 0.15;  ///< speed_m_per_s while the device is above the displayed surface (in a gap)
  double bandwidth_rad_per_s = 40.0;   ///< of the critically damped approach, while no other limit is reached
};

/// The limits with which the station follows the newest image. `stiffest_N_per_m`: the largest slope of the displayed
/// force over depth. The approach alone changes the force by at most 0.035 N in a tick of 0.5 ms.
[[nodiscard]] FollowLimits follow_limits(double stiffest_N_per_m) noexcept;

/// `limits` for an image of this age: from 0.2 s on, the approach slows down in proportion, but not below the default
/// limits. An old image may be wrong, and a fast approach to it gives the hand energy.
[[nodiscard]] FollowLimits slowed_by_age(FollowLimits limits, double age_s) noexcept;

/// The share of the difference between wanted and present rate that one step of next_rate() removes, 1 - exp(-2
/// bandwidth dt). Keeps the last result, because the time between ticks seldom changes.
class FollowShare {
 public:
  [[nodiscard]] double of(double bandwidth_rad_per_s, double dt_s) noexcept;

 private:
  LastResult share_;
};

/// One step of a critically damped approach with bounded speed and acceleration. `rate`: rate of the value; `error`:
/// target minus value; `target_rate`: rate of the target; `share`: FollowShare::of() of the same bandwidth and `dt_s`.
/// Returns the next rate of the value. The result depends only on the present error and rates, so the approach is the
/// same whether the target is updated 10 or 200 times a second.
[[nodiscard]] Eigen::Vector3d next_rate(const Eigen::Vector3d& rate, const Eigen::Vector3d& error,
                                        const Eigen::Vector3d& target_rate, const FollowLimits& limits, double share,
                                        double dt_s) noexcept;

/// The displayed surface: the newest surface, translated and tilted by a lag that decays to zero. The displayed
/// position, normal and speed stay continuous when a newer snapshot replaces the last one. A query is moved by the lag
/// before the newest surface is evaluated, so a large lag does not move the query out of that surface's reach. This
/// class keeps no snapshot, so the caller may free the older one. Owner: the haptic thread.
class SurfaceFollower {
 public:
  explicit SurfaceFollower(const FollowLimits& limits) noexcept : limits_(limits) {}

  /// The point of the newest surface that corresponds to the displayed point `shown`: `shown` moved by lag and tilt.
  [[nodiscard]] Eigen::Vector3d on_newest(const Eigen::Vector3d& shown) const noexcept;
  /// The sample of the displayed surface at a point, given `newest`, the sample of the newest surface at on_newest() of
  /// that point.
  [[nodiscard]] FieldSample shown(const FieldSample& newest) const noexcept;

  void set_limits(const FollowLimits& limits) noexcept { limits_ = limits; }

  /// Sets lag and tilt to zero. The displayed surface then moves at `speed_m_per_s`, limited, along `normal`.
  void follow_at_once(const Eigen::Vector3d& normal, double speed_m_per_s) noexcept;
  /// Call when a newer surface replaces the last one. Displays its point `there`, with `newest_normal`, at `foot`, with
  /// `normal`. The displayed position and speed do not change, nor a normal that turns by up to 0.5 rad.
  void take_over(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal, const Eigen::Vector3d& there,
                 const Eigen::Vector3d& newest_normal) noexcept;
  /// Advances the displayed surface by `dt_s`, while the newest surface moves at `newest_speed_m_per_s` along `normal`
  /// at `foot`. `gap_m`: height of the device above the displayed surface; not positive: no gap. In a gap the surface
  /// gives no force, so it may approach the newest surface faster.
  void advance(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal, double newest_speed_m_per_s, double gap_m,
               double dt_s) noexcept;

  /// The vector from the displayed foot to the corresponding point of the newest surface.
  [[nodiscard]] const Eigen::Vector3d& lag_m() const noexcept { return lag_m_; }
  [[nodiscard]] const Eigen::Vector3d& velocity_m_per_s() const noexcept { return velocity_m_per_s_; }

 private:
  void turn_about(const Eigen::Vector3d& pivot) noexcept;

  FollowLimits limits_;
  Eigen::Vector3d pivot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d lag_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_per_s_ = Eigen::Vector3d::Zero();  ///< velocity of the displayed surface at the pivot
  Eigen::Vector3d tilt_rad_ = Eigen::Vector3d::Zero();          ///< rotation from displayed to newest, about the pivot
  Eigen::Vector3d turn_rad_per_s_ = Eigen::Vector3d::Zero();    ///< angular velocity of the displayed surface
  FollowShare share_;
  FollowShare turn_share_;
};

/// Follows the displayed skin along one fixed line, for a point of the skin that the device has left, such as the point
/// where contact began. Owner: the haptic thread.
class LineFollower {
 public:
  explicit LineFollower(const FollowLimits& limits) noexcept : limits_(limits) {}

  void set_limits(const FollowLimits& limits) noexcept { limits_ = limits; }

  /// Starts at the point `at`, with the rate `rate_m_per_s` along the line's direction `along` (unit).
  void begin(const Eigen::Vector3d& at, const Eigen::Vector3d& along, double rate_m_per_s) noexcept;
  /// Moves the point along the line by `dt_s` towards the newest surface. That surface crosses the line at the distance
  /// `error_m` from the point in the direction `along`, and moves at `target_m_per_s` in this direction.
  void advance(double error_m, double target_m_per_s, double dt_s) noexcept;

  [[nodiscard]] Eigen::Vector3d at() const noexcept { return start_ + risen_m_ * along_; }
  [[nodiscard]] const Eigen::Vector3d& along() const noexcept { return along_; }
  [[nodiscard]] double risen_m() const noexcept { return risen_m_; }  ///< from the start, along the line
  [[nodiscard]] double rate_m_per_s() const noexcept { return rate_m_per_s_; }

 private:
  FollowLimits limits_;
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_ = Eigen::Vector3d::UnitZ();
  double risen_m_ = 0.0;
  double rate_m_per_s_ = 0.0;
  FollowShare share_;
};

}  // namespace telepalp::surface
