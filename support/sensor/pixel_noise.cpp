#include "support/sensor/pixel_noise.h"

namespace telepalp::sensor {
namespace {

/// The normal distribution's quantile by bisection of erfc: slow and exact; it is called once for each entry of a
/// table.
double normal_quantile(double probability) {
  double low = -8.0;
  double high = 8.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

GaussianTable make_table() {
  GaussianTable table{};
  double sum_of_squares = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = normal_quantile((static_cast<double>(i) + 0.5) / static_cast<double>(table.size()));
    sum_of_squares += value * value;
    table[i] = static_cast<float>(value);
  }
  // Restores the variance that the truncation of the tails removed.
  const double scale = std::sqrt(static_cast<double>(table.size()) / sum_of_squares);
  for (float& value : table) value = static_cast<float>(scale * static_cast<double>(value));
  return table;
}

}  // namespace

const GaussianTable& gaussian_table() {
  static const GaussianTable table = make_table();
  return table;
}

}  // namespace telepalp::sensor
