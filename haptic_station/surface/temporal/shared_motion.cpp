#include "haptic_station/surface/temporal/shared_motion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "haptic_station/surface/temporal/leaning_mean.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

// The memory of the fading-memory filter for position, speed and acceleration (Brookner 1998, 1.3). It is short while
// the innovations have a consistent sign, because the motion changes then.
constexpr double kCalm_s = 0.12;
constexpr double kQuick_s = 0.07;
constexpr double kSharedCalmUpTo = 2.0;   // mean innovation [sigma]
constexpr double kSharedQuickFrom = 6.0;  // mean innovation [sigma]
constexpr double kDoubt =
    3.0;  // of an innovation of so many sigma, half moves the surface at once; of a larger one, more
constexpr double kOutlier = 4.0;      // a cell counts less if it deviates by more than this [sigma] …
constexpr double kOddShare = 0.3;     // … plus this share of its expected innovation
constexpr double kMovesWithIt = 0.3;  // least share of a cell that enters the median
constexpr double kLeastAgreement =
    0.85;  // share of the cells; with less, the motion is not shared: the camera was pushed
constexpr int kMotionLooks = 2;
constexpr double kLearnOver_s = 6.0;
constexpr double kFirstShare_m2 = 0.09e-6;  // prior: until the variance exceeds (0.3 mm)², all shares are near 1
constexpr double kJudgeOver_s = 10.0;
constexpr double kGoodFaith = 1.5e-5;  // weight of the prior that both coefficients are 1 [m² s / s²]
constexpr double kPaceOver_s = 10.0;
constexpr double kPaceAhead_s = 0.1;  // an acceleration counts as the speed that it adds in this time
constexpr double kUnusual = 4.0;      // ratio to the mean pace; a breath's largest pace is about twice its mean
constexpr double kLeastUnusual_m_per_s = 0.02;  // a patient at rest does not breathe faster
constexpr double kUnmodelledFor_s = 1.0;        // `unmodelled_` falls from 1 to 0 in this time, so that it can be seen
constexpr double kLately_s = 0.5;
constexpr double kLateDoubt_m2 = 4e-6;  // prior of (2 mm)²: the speed is not used before 2 mm were predicted rightly

}  // namespace

SharedMotion::SharedMotion(std::size_t cells) : share_(cells, 1.0), moments_(cells) {
  for (std::size_t i = 0; i < judges_.size(); ++i) judges_[i].ahead_s = kForesightAges_s[i];
}

ForesightShare SharedMotion::speed_share() const noexcept {
  ForesightShare share{};
  for (std::size_t i = 0; i < judges_.size(); ++i) {
    const Judge& one = judges_[i];
    const double lately = std::max(0.0, one.lately_came_m2 / (one.lately_said_m2 + kLateDoubt_m2));
    share[i] = usual_ * one.right[0] + (1.0 - usual_) * std::min(one.right[0], lately);
  }
  return share;
}

ForesightShare SharedMotion::acceleration_share() const noexcept {
  ForesightShare share{};
  for (std::size_t i = 0; i < judges_.size(); ++i) share[i] = usual_ * judges_[i].right[1];
  return share;
}

void SharedMotion::predict(std::span<const SharedPrediction> cells, double dt_s, double rad_per_s) noexcept {
  double sum = 1e-30;
  Eigen::Vector3d by = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sum += share_[i] * share_[i];
    by += share_[i] * Eigen::Vector3d(cells[i].change_m, cells[i].speed_m_per_s, cells[i].acceleration_m_per_s2);
  }
  by /= sum;
  shared_m_ += by[0];
  speed_m_per_s_ = by[1];
  acceleration_m_per_s2_ = by[2];
  now_s_ += dt_s;
  rad_per_s_ = rad_per_s;
}

/// The median innovation, over the cells that move with the body.
double SharedMotion::median_m(std::span<const SharedInnovation> seen) {
  said_m_.clear();
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i].sigma_m > 0.0 && share_[i] > kMovesWithIt) said_m_.push_back(seen[i].m / share_[i]);
  return said_m_.empty() ? 0.0 : median_of(said_m_);
}

/// Iterated least squares over the cells, starting at the median; outliers get small weights.
SharedMotion::Estimate SharedMotion::estimate_of(std::span<const SharedInnovation> seen) {
  Estimate estimate{.m = median_m(seen)};
  for (int look = 0; look < kMotionLooks; ++look) {
    double sum = 1e-30;
    double by = 0.0;
    double noise = 0.0;
    double measured = 1e-9;
    double agree = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i].sigma_m <= 0.0) continue;
      const double expected_m = share_[i] * estimate.m;
      const double off_m = std::abs(seen[i].m - expected_m);
      const double limit_m = kOutlier * seen[i].sigma_m + kOddShare * std::abs(expected_m);
      const double trust = off_m <= limit_m ? 1.0 : limit_m * limit_m / (off_m * off_m);
      measured += 1.0;
      agree += off_m <= limit_m ? 1.0 : 0.0;
      const double weight = trust * share_[i] / (seen[i].sigma_m * seen[i].sigma_m);
      sum += weight * share_[i];
      by += weight * seen[i].m;
      noise += weight * weight * seen[i].sigma_m * seen[i].sigma_m;
    }
    estimate = {by / sum, std::sqrt(noise) / sum, agree >= kLeastAgreement * measured};
  }
  return estimate;
}

void SharedMotion::correct(std::span<const SharedInnovation> seen, double dt_s) {
  const Estimate estimate = estimate_of(seen);
  innovation_m_ = corrected_m_ = 0.0;
  if (!estimate.agreed) {
    *this = SharedMotion(share_.size());
    unmodelled_ = 1.0;
    return;
  }
  innovation_m_ = estimate.m;
  lean_m_ += kLeanGain * (estimate.m - lean_m_);
  const double quick = leaning(lean_m_, estimate.sigma_m, kSharedCalmUpTo, kSharedQuickFrom);
  const double theta = std::exp(-dt_s / (kCalm_s + quick * (kQuick_s - kCalm_s)));
  const double forgets = 1.0 - theta;
  const double doubt_m = kDoubt * (estimate.sigma_m + 1e-5);
  const double sure = estimate.m * estimate.m / (estimate.m * estimate.m + doubt_m * doubt_m);
  corrected_m_ = std::max(1.0 - theta * theta * theta, sure) * estimate.m;
  shared_m_ += corrected_m_;
  speed_m_per_s_ += 1.5 * forgets * forgets * (1.0 + theta) * estimate.m / dt_s;
  acceleration_m_per_s2_ += forgets * forgets * forgets * estimate.m / (dt_s * dt_s);
  judge_pace(dt_s);
  past_.push_back({now_s_, shared_m_, speed_m_per_s_, acceleration_m_per_s2_});
  while (past_.size() > 1 && now_s_ - past_[1].at_s >= kForesightAges_s.back()) past_.pop_front();
  for (Judge& one : judges_) judge(one, dt_s);
}

/// Compares the pace of the motion with its running mean. Each pace enters the mean with a bounded weight, so that one
/// shift does not make the next one usual.
void SharedMotion::judge_pace(double dt_s) noexcept {
  const double pace = std::abs(speed_m_per_s_) + kPaceAhead_s * std::abs(acceleration_m_per_s2_);
  const double unusual = std::max(kLeastUnusual_m_per_s, kUnusual * mean_pace_m_per_s_);
  const double ratio2 = pace * pace / (unusual * unusual);
  usual_ = 1.0 / (1.0 + ratio2 * ratio2);
  unmodelled_ = std::max(1.0 - usual_, unmodelled_ - dt_s / kUnmodelledFor_s);
  mean_pace_m_per_s_ += std::min(1.0, dt_s / kPaceOver_s) * (std::min(pace, unusual) - mean_pace_m_per_s_);
}

/// Compares the motion of the last `one.ahead_s` with its prediction. A cough stops as suddenly as it begins, so its
/// predictions get less weight than those of a breath.
void SharedMotion::judge(Judge& one, double dt_s) noexcept {
  const double keep = std::exp(-dt_s / kJudgeOver_s);
  one.normal *= keep;
  one.came *= keep;
  const double keep_lately = std::exp(-dt_s / kLately_s);
  one.lately_said_m2 *= keep_lately;
  one.lately_came_m2 *= keep_lately;
  const auto then =
      std::find_if(past_.rbegin(), past_.rend(), [&](const Past& past) { return now_s_ - past.at_s >= one.ahead_s; });
  if (then != past_.rend() && now_s_ - then->at_s < 2.0 * one.ahead_s) {
    const double turned = rad_per_s_ * (now_s_ - then->at_s);
    const Eigen::Vector2d said{then->speed_m_per_s * std::sin(turned) / rad_per_s_,
                               then->acceleration_m_per_s2 * (1.0 - std::cos(turned)) / (rad_per_s_ * rad_per_s_)};
    const double per_m2 = dt_s / (one.ahead_s * one.ahead_s);
    const double came_m = shared_m_ - then->shared_m;
    one.normal += per_m2 * said * said.transpose();
    one.came += per_m2 * came_m * said;
    one.lately_said_m2 += said[0] * said[0];
    one.lately_came_m2 += said[0] * came_m;
  }
  const Eigen::Matrix2d normal = one.normal + kGoodFaith * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d came = one.came + kGoodFaith * Eigen::Vector2d::Ones();
  one.right = normal.inverse() * came;
  // A share that leaves [0, 1] is set to its bound, and the other one is fitted anew.
  for (const int i : {0, 1}) {
    const double bounded = std::clamp(one.right[i], 0.0, 1.0);
    if (bounded == one.right[i]) continue;
    one.right[i] = bounded;
    one.right[1 - i] = (came[1 - i] - normal(0, 1) * bounded) / normal(1 - i, 1 - i);
  }
  one.right = one.right.cwiseMax(0.0).cwiseMin(1.0);
}

void SharedMotion::learn(std::span<const float> displacement_m, double dt_s) {
  learned_s_ += dt_s;
  const double gain = dt_s / std::min(kLearnOver_s, learned_s_);
  mean_m_ += gain * (shared_m_ - mean_m_);
  const double off_m = shared_m_ - mean_m_;
  variance_m2_ += gain * (off_m * off_m - variance_m2_);
  for (std::size_t i = 0; i < moments_.size(); ++i) {
    Moments& cell = moments_[i];
    const double cell_off_m = static_cast<double>(displacement_m[i]) - cell.mean_m;
    cell.mean_m += gain * cell_off_m;
    cell.with_shared_m2 += gain * (cell_off_m * off_m - cell.with_shared_m2);
    share_[i] = (cell.with_shared_m2 + kFirstShare_m2) / (variance_m2_ + kFirstShare_m2);
  }
}

}  // namespace telepalp::surface
