#include "haptic_station/tissue/bulk.h"

#include <algorithm>
#include <cmath>

namespace telepalp::tissue {

using Eigen::Vector3d;

void Bulk::step(const BulkSettings& bulk, const Relaxation& relaxation, const BulkMotion& motion,
                double dt_s) noexcept {
  constexpr double kFull_m = 0.002;
  const double inside = std::min(1.0, motion.inside_m / kFull_m);
  const double most_N = bulk.slips_at_N * inside + bulk.slips_at_N_per_m * motion.inside_m;
  if (bulk.law == BulkLaw::Bristle) {
    bristle_.step(motion.by_m, bulk.stick_N_per_m, most_N, relaxation, dt_s);
  } else {
    damps_ = bulk.damping_N_s_per_m * inside;
    stick_and_slip(bulk, motion, most_N, dt_s);
  }
  cuts_ = motion.cuts;
  cut_.relax(relaxation, dt_s);
  cut_.move({motion.by_m.dot(cuts_), 0.0, 0.0});
  const double bent_m = cut_.extension_m(relaxation).x();
  const double longest_m = bulk.cuts_at_N * motion.uncut / bulk.stick_N_per_m;
  if (bent_m <= 0.0)
    cut_ = {};
  else if (bent_m > longest_m)
    cut_.shorten(longest_m / bent_m);
}

void Bulk::stick_and_slip(const BulkSettings& bulk, const BulkMotion& motion, double most_N, double dt_s) noexcept {
  constexpr double kFalls_s = 0.01;
  constexpr double kSmooth_s = 0.005;
  const bool rests = stopped(bulk, motion.to_m, dt_s);
  stretched_m_ += motion.by_m;
  if (!slips_ && bulk.stick_N_per_m * stretched_m_.norm() > most_N) {
    slips_ = true;
    velocity_ = Vector3d::Zero();
    if (bulk.law == BulkLaw::Paper) whole_ = 0.0;
  }
  if (!slips_) return;
  whole_ = std::max(0.0, whole_ - dt_s / kFalls_s);
  velocity_ += std::min(1.0, dt_s / kSmooth_s) * (motion.by_m / dt_s - velocity_);
  if (!rests || whole_ > 0.0) return;
  slips_ = false;
  whole_ = 1.0;
  stretched_m_ = Vector3d::Zero();
}

bool Bulk::stopped(const BulkSettings& bulk, const Vector3d& at_m, double dt_s) noexcept {
  constexpr double kWindow_s = 0.02;
  constexpr double kSlow_m_per_s = 0.001;
  if (bulk.law == BulkLaw::Paper) {
    const Vector3d shown_m = (at_m / bulk.resolution_m).array().round() * bulk.resolution_m;
    equal_ = shown_m == watched_m_ ? std::min(equal_ + 1, bulk.equal_readings) : 0;
    watched_m_ = shown_m;
    return equal_ >= bulk.equal_readings;
  }
  watched_s_ += dt_s;
  if (watched_s_ < kWindow_s) return false;
  const bool slow = (at_m - watched_m_).norm() < kSlow_m_per_s * watched_s_;
  watched_s_ = 0.0;
  watched_m_ = at_m;
  return slow;
}

Vector3d Bulk::force_N(const BulkSettings& bulk, const Relaxation& relaxation) const noexcept {
  Vector3d sum_N = -bulk.stick_N_per_m * cut_.extension_m(relaxation).x() * cuts_;
  if (bulk.law == BulkLaw::Bristle) return sum_N - bulk.stick_N_per_m * bristle_.bent_m(relaxation);
  sum_N -= whole_ * bulk.stick_N_per_m * stretched_m_;
  return slips_ ? Vector3d(sum_N - damps_ * velocity_) : sum_N;
}

double Bulk::stored_J(const BulkSettings& bulk, const Relaxation& relaxation) const noexcept {
  return bulk.stick_N_per_m *
         (cut_.stored_m2(relaxation) + bristle_.stored_m2(relaxation) + 0.5 * whole_ * stretched_m_.squaredNorm());
}

void Bulk::yield(double share) noexcept {
  bristle_.shorten(share);
  cut_.shorten(share);
  stretched_m_ *= share;
  velocity_ *= share;
}

}  // namespace telepalp::tissue
