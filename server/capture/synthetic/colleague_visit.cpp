#include "server/capture/synthetic/colleague_visit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "proto/words/smooth_step.h"

namespace telepalp::capture {
namespace {

constexpr double kAway_m = 0.5;     // the hand at this distance from its place is outside the image
constexpr double kHigher_m = 0.3;   // a hand from above comes down from this height over its place
constexpr double kGlides_m = 0.06;  // a hand that will lie on the skin comes this high over it …
constexpr double kLowers_m = 0.15;  // … and comes down over this last part of its way
constexpr double kLift_rad = 0.2;

double way_m(const ColleagueVisit& visit) noexcept { return kAway_m + (visit.from_above ? kHigher_m : 0.0); }

/// Way that is left to the hand's place on its way in, or done on its way out [m]; infinite: the hand is not there.
double way_left_m(const ColleagueVisit& visit, double time_s) noexcept {
  const double comes_m = way_m(visit) - ColleagueVisit::kSpeed_m_per_s * (time_s - visit.begins_s);
  const double goes_m = comes_m < 0.0 ? -comes_m - ColleagueVisit::kSpeed_m_per_s * visit.stays_s : 0.0;
  const double left_m = std::max({comes_m, goes_m, 0.0});
  return left_m > way_m(visit) ? std::numeric_limits<double>::infinity() : left_m;
}

/// Height over the place that is still to be lost [m].
double higher_m(const ColleagueVisit& visit, double left_m) noexcept {
  if (visit.from_above) return std::min(left_m, kHigher_m);
  return visit.over_m > 0.0 ? 0.0 : kGlides_m * smooth_step(left_m / kLowers_m);
}

}  // namespace

double ColleagueVisit::gone_s() const noexcept { return begins_s + 2.0 * way_m(*this) / kSpeed_m_per_s + stays_s; }

std::optional<ColleagueHand> ColleagueVisit::at(double time_s, const TrueSurface& rest, const TrueSurface& now) const {
  const double left_m = way_left_m(*this, time_s);
  if (!std::isfinite(left_m)) return std::nullopt;
  const double aside_m = from_above ? std::max(0.0, left_m - kHigher_m) : left_m;
  ColleagueHand hand{.under_palm_m = (over_m > 0.0 ? rest : now).on_ray_through(place).at.m,
                     .heading_rad = heading_rad,
                     .arm_rise_rad = arm_rise_rad,
                     .lifts = {}};
  hand.under_palm_m -= aside_m * Eigen::Vector3d{std::cos(heading_rad), std::sin(heading_rad), 0.0};
  hand.under_palm_m.z() -= over_m + higher_m(*this, left_m);
  for (std::size_t i = 0; i < hand.lifts.size(); ++i)
    hand.lifts[i] = kLift_rad * (1.0 + std::sin(2.0 * std::numbers::pi * fingers_hz * time_s + static_cast<double>(i)));
  return hand;
}

}  // namespace telepalp::capture
