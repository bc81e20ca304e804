#pragma once

#include <array>
#include <span>
#include <vector>

namespace telepalp::surface {

/// What the pixels of one cell say together.
struct CellMean {
  double mean = 0.0;
  double count = 0.0;  ///< of pixels; 0: nothing seen, and the mean says nothing
};

/// A smooth function over an image, known by cells of kCell_px × kCell_px pixels: a cubic B-spline with one coefficient
/// for each cell, at its centre. C2, so that what moves by it gets no kinks.
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

/// The four cells along one axis whose coefficients make the function at a pixel, with their shares, sum 1.
struct Knots {
  std::array<int, 4> cell{};
  std::array<float, 4> share{};
};
[[nodiscard]] Knots knots_at(double pixel, int cells) noexcept;

/// Values of the function over one row of pixels. `out`: padded by half a cell on the left, so pixel u is at
/// out[u + kRowLead]; at least row_length() long.
inline constexpr int kRowLead = CellLattice::kCell_px / 2;
[[nodiscard]] inline std::size_t row_length(const CellLattice& lattice) noexcept {
  return static_cast<std::size_t>(lattice.columns + 1) * CellLattice::kCell_px;
}
void spread_over_row(const CellLattice& lattice, std::span<const float> coefficients, int row, std::span<float> out);

/// Coefficients from the cells' means, smoothed. Means over cells, smoothing and the spline each flatten what they
/// meet, together by 17/12 of a cell² times half the second derivative: the kernel takes that back, so any quadratic
/// comes out exactly. A cell with few pixels leans on its neighbours; where nothing is seen around, 0.
[[nodiscard]] std::vector<float> smooth_coefficients(const CellLattice& lattice, std::span<const CellMean> means);

/// Means over the cells of a function known by its coefficients.
[[nodiscard]] std::vector<float> means_of(const CellLattice& lattice, std::span<const float> coefficients);

/// Each cell's mean with those of its neighbourhood, kWide_cells on a side.
inline constexpr int kWide_cells = 5;
[[nodiscard]] std::vector<CellMean> wide_means(const CellLattice& lattice, std::span<const CellMean> means);

}  // namespace telepalp::surface
