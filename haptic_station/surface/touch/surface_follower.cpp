#include "haptic_station/surface/touch/surface_follower.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

// The displayed surface follows the newest one's speed up to this limit.
constexpr double kFastestSurface_m_per_s = 0.3;
constexpr double kAccelerationInGap_m_per_s2 = 6.0;
// The greatest speed in a gap is the gap's width divided by this time, so that the surface has slowed down when it
// meets the device.
constexpr double kClosesGapOver_s = 0.05;
constexpr double kLongestStep_s = 0.002;  // a longer tick is integrated in several steps
constexpr FollowLimits kTurn{.speed_m_per_s = 1.0,
                             .acceleration_m_per_s2 = 30.0};  // values in radians instead of metres
constexpr double kSteepest_rad = 0.5;  // largest tilt for which the small-angle approximation holds

Vector3d at_most(const Vector3d& v, double length) noexcept {
  const double norm = v.norm();
  return norm > length ? Vector3d(v * (length / norm)) : v;
}

/// Calls `step(part_s)` for parts of `dt_s` that are short enough to integrate.
template <class Step>
void in_parts(double dt_s, const Step& step) noexcept {
  const int parts = static_cast<int>(std::clamp(std::ceil(dt_s / kLongestStep_s), 1.0, 64.0));
  for (int part = 0; part < parts; ++part) step(dt_s / parts);
}

FollowLimits in_gap(FollowLimits limits, double gap_m) noexcept {
  const double speed_m_per_s = std::min(gap_m / kClosesGapOver_s, limits.speed_in_gap_m_per_s);
  limits.speed_m_per_s = std::max(limits.speed_m_per_s, speed_m_per_s);
  limits.acceleration_m_per_s2 = std::max(limits.acceleration_m_per_s2, kAccelerationInGap_m_per_s2);
  return limits;
}

}  // namespace

FollowLimits follow_limits(double stiffest_N_per_m) noexcept {
  constexpr double kMostStep_N = 0.035;
  constexpr double kTick_s = 0.0005;
  constexpr double kFastest_m_per_s = 0.2;
  FollowLimits limits;
  const double most_m_per_s = kMostStep_N / (std::max(stiffest_N_per_m, 1.0) * kTick_s);
  limits.speed_m_per_s = std::min(kFastest_m_per_s, most_m_per_s);
  limits.speed_in_gap_m_per_s = std::max(limits.speed_in_gap_m_per_s, limits.speed_m_per_s);
  limits.acceleration_m_per_s2 = 50.0;
  limits.bandwidth_rad_per_s = 400.0;
  return limits;
}

FollowLimits slowed_by_age(FollowLimits limits, double age_s) noexcept {
  constexpr double kFresh_s = 0.2;
  const double pace = age_s > kFresh_s ? kFresh_s / age_s : 1.0;
  const FollowLimits least;
  const auto slowed = [pace](double limit, double cautious) {
    return std::max(pace * limit, std::min(limit, cautious));
  };
  limits.speed_m_per_s = slowed(limits.speed_m_per_s, least.speed_m_per_s);
  limits.acceleration_m_per_s2 = slowed(limits.acceleration_m_per_s2, least.acceleration_m_per_s2);
  return limits;
}

double FollowShare::of(double bandwidth_rad_per_s, double dt_s) noexcept {
  return share_.of(-2.0 * bandwidth_rad_per_s * dt_s, [](double x) noexcept { return -std::expm1(x); });
}

Vector3d next_rate(const Vector3d& rate, const Vector3d& error, const Vector3d& target_rate, const FollowLimits& limits,
                   double share, double dt_s) noexcept {
  const Vector3d wanted = at_most(target_rate, kFastestSurface_m_per_s) +
                          at_most(0.5 * limits.bandwidth_rad_per_s * error, limits.speed_m_per_s);
  return rate + at_most(share * (wanted - rate), limits.acceleration_m_per_s2 * dt_s);
}

// A point x of the displayed surface corresponds to q = x + lag + tilt × (x − pivot) of the newest surface: a rigid
// motion, to first order in the tilt.
Vector3d SurfaceFollower::on_newest(const Vector3d& shown) const noexcept {
  return shown + lag_m_ + tilt_rad_.cross(shown - pivot_);
}

FieldSample SurfaceFollower::shown(const FieldSample& newest) const noexcept {
  if (!newest.valid) return newest;
  FieldSample out = newest;
  out.gradient -= tilt_rad_.cross(newest.gradient);  // the transpose of dq/dx
  const double length = out.gradient.norm();
  if (length > 0.1) out.normal = out.gradient / length;
  out.velocity_m_per_s = velocity_m_per_s_.dot(out.normal);
  return out;
}

void SurfaceFollower::follow_at_once(const Vector3d& normal, double speed_m_per_s) noexcept {
  lag_m_.setZero();
  tilt_rad_.setZero();
  turn_rad_per_s_.setZero();
  velocity_m_per_s_ = at_most(speed_m_per_s * normal, kFastestSurface_m_per_s);
}

void SurfaceFollower::take_over(const Vector3d& foot, const Vector3d& normal, const Vector3d& there,
                                const Vector3d& newest_normal) noexcept {
  pivot_ = foot;
  lag_m_ = there - foot;
  tilt_rad_ = at_most(normal.cross(newest_normal), kSteepest_rad);
}

/// Rewrites the motion about another pivot.
void SurfaceFollower::turn_about(const Vector3d& pivot) noexcept {
  lag_m_ += tilt_rad_.cross(pivot - pivot_);
  pivot_ = pivot;
}

void SurfaceFollower::advance(const Vector3d& foot, const Vector3d& normal, double newest_speed_m_per_s, double gap_m,
                              double dt_s) noexcept {
  turn_about(foot);
  const FollowLimits limits = gap_m > 0.0 ? in_gap(limits_, gap_m) : limits_;
  const Vector3d newest = newest_speed_m_per_s * normal;
  in_parts(dt_s, [&](double part_s) noexcept {
    velocity_m_per_s_ =
        next_rate(velocity_m_per_s_, lag_m_, newest, limits, share_.of(limits.bandwidth_rad_per_s, part_s), part_s);
    lag_m_ += part_s * (newest - velocity_m_per_s_);
    turn_rad_per_s_ = next_rate(turn_rad_per_s_, tilt_rad_, Vector3d::Zero(), kTurn,
                                turn_share_.of(kTurn.bandwidth_rad_per_s, part_s), part_s);
    tilt_rad_ -= part_s * turn_rad_per_s_;
  });
}

void LineFollower::begin(const Vector3d& at, const Vector3d& along, double rate_m_per_s) noexcept {
  start_ = at;
  along_ = along;
  risen_m_ = 0.0;
  rate_m_per_s_ = rate_m_per_s;
}

void LineFollower::advance(double error_m, double target_m_per_s, double dt_s) noexcept {
  in_parts(dt_s, [&](double part_s) noexcept {
    const Vector3d rate = next_rate({rate_m_per_s_, 0.0, 0.0}, {error_m, 0.0, 0.0}, {target_m_per_s, 0.0, 0.0}, limits_,
                                    share_.of(limits_.bandwidth_rad_per_s, part_s), part_s);
    rate_m_per_s_ = rate.x();
    risen_m_ += part_s * rate_m_per_s_;
    error_m += part_s * (target_m_per_s - rate_m_per_s_);
  });
}

}  // namespace telepalp::surface
