#include "haptic_station/tracking/velocity_persistence.h"

#include <algorithm>
#include <cmath>

namespace telepalp::tracking {
namespace {

constexpr double kShortest_s = 0.03;
constexpr double kLongest_s = 0.08;
constexpr double kMost_per_s = 20.0;
constexpr double kPrior = 1e-7;  // weight of the expected time constant: that of a few samples at 0.1 m/s

}  // namespace

VelocityPersistence::VelocityPersistence(double expected_s, double memory_s) noexcept
    : expected_per_s_(1.0 / expected_s), memory_s_(memory_s), brakes_per_s_(expected_per_s_) {}

/// The oldest state that is 30 to 80 ms old.
const VelocityPersistence::State* VelocityPersistence::a_while_before(SessionTime at) const noexcept {
  for (std::size_t back = count_; back > 0; --back) {
    const State& past = states_[(next_ + kStates - back) % kStates];
    const double age_s = to_seconds(at - past.at);
    if (age_s < kShortest_s) return nullptr;
    if (age_s < kLongest_s) return &past;
  }
  return nullptr;
}

// A velocity v that dies away at the rate c leads, after a short time a, to v (a - c a^2 / 2): c follows by least
// squares from the distances by which a straight-line prediction overshot.
void VelocityPersistence::add(SessionTime at, const Eigen::Vector3d& hand_m, const Eigen::Vector3d& velocity_m_per_s,
                              double dt_s) noexcept {
  if (const State* past = a_while_before(at)) {
    const double forget = std::exp(-dt_s / memory_s_);
    const double a_s = to_seconds(at - past->at);
    const Eigen::Vector3d& v = past->velocity_m_per_s;
    const Eigen::Vector3d too_far_m = past->hand_m + a_s * v - hand_m;
    lost_ = forget * lost_ + 0.5 * a_s * a_s * v.dot(too_far_m);
    weight_ = forget * weight_ + 0.25 * a_s * a_s * a_s * a_s * v.squaredNorm();
    brakes_per_s_ = std::clamp((lost_ + 0.25 * kPrior * expected_per_s_) / (weight_ + 0.25 * kPrior), 0.0, kMost_per_s);
  }
  states_[next_] = {at, hand_m, velocity_m_per_s};
  next_ = (next_ + 1) % kStates;
  count_ = std::min(count_ + 1, kStates);
}

double VelocityPersistence::reach_s(double ahead_s) const noexcept {
  constexpr double kKeepsIt_per_s = 1e-6;
  if (brakes_per_s_ < kKeepsIt_per_s) return ahead_s;
  return -std::expm1(-brakes_per_s_ * ahead_s) / brakes_per_s_;
}

double VelocityPersistence::left(double ahead_s) const noexcept { return std::exp(-brakes_per_s_ * ahead_s); }

}  // namespace telepalp::tracking
