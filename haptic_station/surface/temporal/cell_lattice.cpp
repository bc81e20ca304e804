#include "haptic_station/surface/temporal/cell_lattice.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/temporal/filter_rows.h"
#include "proto/words/numbers/cubic_b_spline.h"

namespace telepalp::surface {
namespace {

constexpr int kCell = CellLattice::kCell_px;

/// The basis functions at each pixel between the centres of two cells, [spline][pixel].
constexpr auto kByPixel = [] {
  std::array<float, 4 * kCell> by_pixel{};
  for (std::size_t pixel = 0; pixel < kCell; ++pixel) {
    const auto at = cubic_b_spline((static_cast<float>(pixel) + 0.5F) / kCell).weight;
    for (std::size_t spline = 0; spline < 4; ++spline) by_pixel[spline * kCell + pixel] = at[spline];
  }
  return by_pixel;
}();
static_assert(kCell == 16, "spline_row() is written for cells of 16 pixels");

// Two passes of the kernel 1 2 1, sharpened so that the second moment is -5/12. This compensates the spline (1/3) and
// the mean over a cell (1/12). The spectrum of the kernel is nowhere negative; otherwise a filter whose output returns
// to its input would be unstable.
constexpr double kSharpen = 17.0 / 12.0;
constexpr std::array<double, 4> kKernel = {
    6.0 / 16.0 * (1.0 + kSharpen) - 4.0 / 16.0 * kSharpen, 4.0 / 16.0 * (1.0 + kSharpen) - 3.5 / 16.0 * kSharpen,
    1.0 / 16.0 * (1.0 + kSharpen) - 2.0 / 16.0 * kSharpen, -0.5 / 16.0 * kSharpen};
static_assert(kKernel[0] + 2.0 * (kKernel[1] + kKernel[2] + kKernel[3]) > 0.999999);
static_assert(2.0 * (kKernel[1] + 4.0 * kKernel[2] + 9.0 * kKernel[3]) < -0.41666);

constexpr double kLeaning_px = 32.0;  // a cell with this many pixels counts as much as its neighbours

/// Mean over the cells within `radius` of a cell, weighted by their numbers of pixels.
CellMean mean_around(const CellLattice& lattice, std::span<const CellMean> means, int column, int row, int radius) {
  CellMean around;
  for (int r = std::max(0, row - radius); r <= std::min(lattice.rows - 1, row + radius); ++r)
    for (int c = std::max(0, column - radius); c <= std::min(lattice.columns - 1, column + radius); ++c) {
      const CellMean& near = means[lattice.at(c, r)];
      around.mean += near.count * near.mean;
      around.count += near.count;
    }
  around.mean /= std::max(around.count, 1.0);
  return around;
}

/// Each cell's mean, blended with its neighbours' mean; the fewer pixels the cell has, the more the neighbours count.
std::vector<double> filled(const CellLattice& lattice, std::span<const CellMean> means) {
  std::vector<double> out(lattice.size(), 0.0);
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column) {
      const CellMean& own = means[lattice.at(column, row)];
      double& value = out[lattice.at(column, row)];
      value = own.mean;
      if (own.count >= 0.75 * kCell * kCell) continue;
      const double mean = mean_around(lattice, means, column, row, 1).mean;
      value = (own.count * own.mean + kLeaning_px * mean) / (own.count + kLeaning_px);
    }
  return out;
}

// The weights of the surrounding coefficients in a cubic spline's mean over a cell: a quartic spline at its knots.
constexpr std::array<double, 3> kMeanOfSpline = {230.0 / 384.0, 76.0 / 384.0, 1.0 / 384.0};

/// Convolves with a symmetric kernel along one axis. Neighbours are `stride` apart; the border's value continues beyond
/// the border.
template <std::size_t N>
void convolve(const std::array<double, N>& kernel, std::span<const double> in, std::span<double> out, std::size_t start,
              std::size_t stride, int count) {
  const auto at = [&](int i) { return in[start + static_cast<std::size_t>(std::clamp(i, 0, count - 1)) * stride]; };
  for (int i = 0; i < count; ++i) {
    double sum = kernel[0] * at(i);
    for (int k = 1; k < static_cast<int>(N); ++k) sum += kernel[static_cast<std::size_t>(k)] * (at(i - k) + at(i + k));
    out[start + static_cast<std::size_t>(i) * stride] = sum;
  }
}

template <std::size_t N>
std::vector<float> convolved(const std::array<double, N>& kernel, const CellLattice& lattice,
                             std::vector<double> values) {
  std::vector<double> across(values.size());
  const auto columns = static_cast<std::size_t>(lattice.columns);
  for (int row = 0; row < lattice.rows; ++row)
    convolve(kernel, values, across, static_cast<std::size_t>(row) * columns, 1, lattice.columns);
  for (std::size_t column = 0; column < columns; ++column)
    convolve(kernel, across, values, column, columns, lattice.rows);
  return {values.begin(), values.end()};
}

}  // namespace

CellLattice lattice_of(int width_px, int height_px) noexcept {
  return {(width_px + kCell - 1) / kCell, (height_px + kCell - 1) / kCell};
}

Knots knots_at(double pixel, int cells) noexcept {
  const double x = std::clamp((pixel + 0.5) / kCell - 0.5, -0.5, static_cast<double>(cells) - 0.5);
  const int first = static_cast<int>(std::floor(x));
  Knots knots{.cell = {}, .share = cubic_b_spline(static_cast<float>(x - first)).weight};
  for (int k = 0; k < 4; ++k) knots.cell[static_cast<std::size_t>(k)] = std::clamp(first - 1 + k, 0, cells - 1);
  return knots;
}

void spread_over_row(const CellLattice& lattice, std::span<const float> coefficients, int row, std::span<float> out) {
  const Knots down = knots_at(row, lattice.rows);
  std::vector<float> blended(static_cast<std::size_t>(lattice.columns) + 4);
  for (int column = -2; column < lattice.columns + 2; ++column) {
    float& sum = blended[static_cast<std::size_t>(column + 2)];
    for (std::size_t k = 0; k < 4; ++k)
      sum += down.share[k] * coefficients[lattice.at(std::clamp(column, 0, lattice.columns - 1), down.cell[k])];
  }
  spline_row(blended.data(), lattice.columns + 1, kByPixel.data(), out.data());
}

std::vector<float> smooth_coefficients(const CellLattice& lattice, std::span<const CellMean> means) {
  return convolved(kKernel, lattice, filled(lattice, means));
}

std::vector<float> means_of(const CellLattice& lattice, std::span<const float> coefficients) {
  return convolved(kMeanOfSpline, lattice, {coefficients.begin(), coefficients.end()});
}

std::vector<CellMean> wide_means(const CellLattice& lattice, std::span<const CellMean> means) {
  std::vector<CellMean> wide(lattice.size());
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      wide[lattice.at(column, row)] = mean_around(lattice, means, column, row, kWide_cells / 2);
  return wide;
}

}  // namespace telepalp::surface
