#include "tools/study/figures/t_test.h"

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "tools/study/figures/statistics.h"

namespace telepalp::study {
namespace {

constexpr double kLevel = 0.05;
constexpr int kMostPeople = 10'000;
// Beyond this, the power is 1 within rounding, and the series of the noncentral distribution becomes slow.
constexpr double kLargeShift = 30.0;

double critical_t(double degrees) {
  return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees), kLevel / 2.0));
}

/// Power of a two-sided test whose t has the noncentrality `shift`.
double power_of(double shift, double degrees) {
  if (std::abs(shift) > kLargeShift) return 1.0;
  if (shift == 0.0) return kLevel;
  const boost::math::non_central_t distribution(degrees, shift);
  const double t = critical_t(degrees);
  return boost::math::cdf(boost::math::complement(distribution, t)) + boost::math::cdf(distribution, -t);
}

TTest test_of(double difference, double error, double degrees, double deviation) {
  TTest test{.difference = difference, .low = difference, .high = difference, .degrees = degrees};
  if (!(error > 0.0)) {
    test.p = difference == 0.0 ? 1.0 : 0.0;
    return test;
  }
  const boost::math::students_t distribution(degrees);
  const double reach = critical_t(degrees) * error;
  test.low -= reach;
  test.high += reach;
  test.t = difference / error;
  test.p = 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(test.t)));
  test.effect = difference / deviation;
  test.power = power_of(test.t, degrees);
  return test;
}

}  // namespace

Sample sample_of(std::span<const double> values) noexcept {
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto count = static_cast<int>(values.size());
  return {mean, count > 1 ? std::sqrt(squares / (count - 1)) : 0.0, count};
}

TTest welch_test(const Sample& first, const Sample& second) noexcept {
  const double a = first.deviation * first.deviation / first.count;
  const double b = second.deviation * second.deviation / second.count;
  const double degrees =
      a + b > 0.0 ? (a + b) * (a + b) / (a * a / (first.count - 1) + b * b / (second.count - 1)) : 1.0;
  const double deviation = std::sqrt(0.5 * (first.deviation * first.deviation + second.deviation * second.deviation));
  return test_of(first.mean - second.mean, std::sqrt(a + b), degrees, deviation);
}

TTest paired_test(std::span<const double> first, std::span<const double> second) {
  std::vector<double> differences(first.begin(), first.end());
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= second[i];
  const Sample sample = sample_of(differences);
  return test_of(sample.mean, sample.deviation / std::sqrt(sample.count), sample.count - 1, sample.deviation);
}

int people_for_power(double effect, bool paired) noexcept {
  for (int people = 3; people < kMostPeople; people += 1 + people / 50) {
    const double shift = std::abs(effect) * std::sqrt(paired ? people : 0.5 * people);
    if (power_of(shift, paired ? people - 1 : 2 * people - 2) >= 0.8) return people;
  }
  return kMostPeople;
}

}  // namespace telepalp::study
