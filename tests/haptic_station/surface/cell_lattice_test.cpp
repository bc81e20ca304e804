#include "haptic_station/surface/temporal/cell_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace telepalp::surface {
namespace {

constexpr int kWidth_px = 320;
constexpr int kHeight_px = 240;

/// Means over cells of a function of the pixel, without noise.
std::vector<CellMean> means_of_pixels(const CellLattice& lattice, const std::function<double(double, double)>& at) {
  std::vector<CellMean> means(lattice.size());
  for (int v = 0; v < kHeight_px; ++v)
    for (int u = 0; u < kWidth_px; ++u) {
      CellMean& cell = means[lattice.at(u / CellLattice::kCell_px, v / CellLattice::kCell_px)];
      cell.mean += at(u, v);
      cell.count += 1.0;
    }
  for (CellMean& cell : means) cell.mean /= cell.count;
  return means;
}

double worst_error(const CellLattice& lattice, const std::vector<float>& coefficients,
                   const std::function<double(double, double)>& at) {
  std::vector<float> row(row_length(lattice));
  double worst = 0.0;
  for (int v = 5 * 16; v < kHeight_px - 5 * 16; ++v) {
    spread_over_row(lattice, coefficients, v, row);
    for (int u = 5 * 16; u < kWidth_px - 5 * 16; ++u)
      worst = std::max(worst, std::abs(static_cast<double>(row[static_cast<std::size_t>(u + kRowLead)]) - at(u, v)));
  }
  return worst;
}

TEST(CellLattice, AnyQuadraticIsReproducedExactly) {
  const CellLattice lattice = lattice_of(kWidth_px, kHeight_px);
  const auto bowl = [](double u, double v) {
    const double x = (u - 160.0) / 160.0, y = (v - 120.0) / 160.0;
    return 0.3 + 0.1 * x - 0.2 * y + 0.5 * x * x - 0.4 * x * y + 0.7 * y * y;
  };
  EXPECT_LT(worst_error(lattice, smooth_coefficients(lattice, means_of_pixels(lattice, bowl)), bowl), 2e-5);
}

TEST(CellLattice, ABulgeOfABellysSizeKeepsItsHeight) {
  const CellLattice lattice = lattice_of(kWidth_px, kHeight_px);
  const auto bulge = [](double u, double v) {
    return std::exp(-((u - 160.0) * (u - 160.0) + (v - 120.0) * (v - 120.0)) / (2.0 * 80.0 * 80.0));
  };
  EXPECT_LT(worst_error(lattice, smooth_coefficients(lattice, means_of_pixels(lattice, bulge)), bulge), 0.005);
}

/// The filter's output returns to its input. If smoothing amplified any part, the filter would be unstable.
TEST(CellLattice, SmoothingAgainAndAgainNeverAmplifies) {
  const CellLattice lattice = lattice_of(kWidth_px, kHeight_px);
  std::mt19937_64 random(3);
  std::normal_distribution<float> noise;
  std::vector<float> coefficients(lattice.size());
  for (float& coefficient : coefficients) coefficient = noise(random);
  const auto power = [](const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
    return sum;
  };
  const double before = power(coefficients);
  for (int frame = 0; frame < 300; ++frame) {
    const std::vector<float> means = means_of(lattice, coefficients);
    std::vector<CellMean> whole(means.size());
    for (std::size_t i = 0; i < means.size(); ++i) whole[i] = {static_cast<double>(means[i]), 256.0};
    coefficients = smooth_coefficients(lattice, whole);
  }
  EXPECT_LT(power(coefficients), 1.1 * before);
}

TEST(CellLattice, ACellWithoutPixelsTakesItsNeighboursMean) {
  const CellLattice lattice = lattice_of(kWidth_px, kHeight_px);
  std::vector<CellMean> means = means_of_pixels(lattice, [](double, double) { return 0.25; });
  means[lattice.at(10, 7)] = {};
  means[lattice.at(11, 7)] = {1e3, 0.0};
  for (const float coefficient : smooth_coefficients(lattice, means)) EXPECT_NEAR(coefficient, 0.25F, 1e-6F);
}

}  // namespace
}  // namespace telepalp::surface
