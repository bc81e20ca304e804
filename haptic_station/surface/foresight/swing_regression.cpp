#include "haptic_station/surface/foresight/swing_regression.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

constexpr double kMemory_s = 10.0;
constexpr double kFirstWay_m2_s = 9e-8;  // prior: a way of 0.3 mm was not gone for 1 s
constexpr double kMostToMean = 2.0;      // skin that swings comes as far to the other side of its mean place
constexpr double kMostStraight = 1.0;

}  // namespace

void SwingRegression::pass(double dt_s) noexcept {
  const double keep = std::exp(-dt_s / kMemory_s);
  for (double* sum : {&mean_mean_, &mean_straight_, &straight_straight_, &went_mean_, &went_straight_}) *sum *= keep;
}

void SwingRegression::add(const Ways& ways, double counts) noexcept {
  mean_mean_ += counts * ways.to_mean_m * ways.to_mean_m;
  mean_straight_ += counts * ways.to_mean_m * ways.straight_m;
  straight_straight_ += counts * ways.straight_m * ways.straight_m;
  went_mean_ += counts * ways.went_m * ways.to_mean_m;
  went_straight_ += counts * ways.went_m * ways.straight_m;
}

SwingRegression::Shares SwingRegression::shares() const noexcept {
  const double a = mean_mean_ + kFirstWay_m2_s, b = mean_straight_, c = straight_straight_ + kFirstWay_m2_s;
  const double determinant = a * c - b * b;  // above kFirstWay_m2_s², by the inequality of Cauchy and Schwarz
  return {std::clamp((went_mean_ * c - went_straight_ * b) / determinant, 0.0, kMostToMean),
          std::clamp((went_straight_ * a - went_mean_ * b) / determinant, 0.0, kMostStraight)};
}

}  // namespace telepalp::surface
