#pragma once

#include <array>
#include <span>
#include <vector>

namespace telepalp::surface {

/// The mean over the pixels of one cell.
struct CellMean {
  double mean = 0.0;
  double count = 0.0;  ///< number of pixels; 0: no measurement, and the mean is meaningless
};

/// The lattice of a smooth function over an image: a cubic B-spline with one coefficient at the centre of each cell of
/// kCell_px × kCell_px pixels. The function is twice continuously differentiable, so a surface displaced by it gets no
/// kinks.
struct CellLattice {
  static constexpr int kCell_px = 16;

  int columns = 0;
  int rows = 0;

  [[nodiscard]] std::size_t size() const noexcept {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t at(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
};

[[nodiscard]] CellLattice lattice_of(int width_px, int height_px) noexcept;

/// The four cells along one axis whose coefficients determine the function at the coordinate `pixel` [px], and the
/// weights of these coefficients, with the sum 1. `cells`: number of cells along the axis; the outermost repeat.
struct Knots {
  std::array<int, 4> cell{};
  std::array<float, 4> share{};
};
[[nodiscard]] Knots knots_at(double pixel, int cells) noexcept;

/// Values of the function over `row`, one row of pixels. `out` is padded by half a cell on the left: pixel u is at
/// out[u + kRowLead]. `out` has at least row_length() elements.
inline constexpr int kRowLead = CellLattice::kCell_px / 2;
[[nodiscard]] inline std::size_t row_length(const CellLattice& lattice) noexcept {
  return static_cast<std::size_t>(lattice.columns + 1) * CellLattice::kCell_px;
}
void spread_over_row(const CellLattice& lattice, std::span<const float> coefficients, int row, std::span<float> out);

/// Smoothed coefficients from the means of the cells. Averaging over cells, smoothing and the spline each flatten the
/// function; together they would change it by 17/12 cell² times half its second derivative. The smoothing kernel
/// corrects this, so that a quadratic function is reproduced exactly. The fewer measured pixels a cell has, the more
/// its neighbours weigh. An unmeasured cell whose neighbours are unmeasured, too, enters with the value 0.
[[nodiscard]] std::vector<float> smooth_coefficients(const CellLattice& lattice, std::span<const CellMean> means);

/// The mean over each cell of the function with these coefficients.
[[nodiscard]] std::vector<float> means_of(const CellLattice& lattice, std::span<const float> coefficients);

/// For each cell, the mean over the square of kWide_cells × kWide_cells cells centred on it.
inline constexpr int kWide_cells = 5;
[[nodiscard]] std::vector<CellMean> wide_means(const CellLattice& lattice, std::span<const CellMean> means);

}  // namespace telepalp::surface
