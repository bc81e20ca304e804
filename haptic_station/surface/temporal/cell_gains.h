#pragma once

#include <span>
#include <vector>

#include "haptic_station/surface/temporal/cell_lattice.h"

namespace telepalp::surface {

/// The innovation of one cell in a frame: the mean of measured minus predicted depth over `count` pixels.
struct CellInnovation {
  double mean_m = 0.0;
  double count = 0.0;
  double sigma_m = 0.0;  ///< standard deviation of the mean under noise alone
};

/// Least number of pixels for a cell's mean to be used.
inline constexpr double kLeastCount = 12.0;

/// The gains of the cells' g-h filters (position and velocity). They are large where the innovations of a cell's
/// neighbourhood have a consistent sign, because the motion changes there, and small where the innovations are only
/// noise. Source: Brookner 1998, 1.2.6, the critically damped g-h filter.
class CellGains {
 public:
  explicit CellGains(const CellLattice& lattice);

  /// Adds a frame. `seen`: the cells' innovations. `wide`: their means over neighbourhoods, as from wide_means().
  void add(std::span<const CellInnovation> seen, std::span<const CellMean> wide);

  /// The gains g and h: position += g · innovation, velocity += h · innovation / frame period. In the first frames, g
  /// is large; in the first two, h is 0.
  [[nodiscard]] double position(std::size_t cell) const noexcept;
  [[nodiscard]] double velocity(std::size_t cell) const noexcept;

 private:
  [[nodiscard]] double theta(std::size_t cell) const noexcept;

  CellLattice lattice_;
  std::vector<double> lean_m_;    ///< running mean of each neighbourhood's innovation; 0: the filter does not lag
  std::vector<CellMean> moving_;  ///< significance of each neighbourhood's mean innovation, 0 (noise) to 1
  double frames_ = 0.0;
};

/// Moves each velocity (spline coefficient) by a tenth towards its smoothed value. smooth_coefficients() removes rough
/// parts of the innovations, so the filters cannot correct rough parts of the velocities, which would stay.
void smooth_velocities(const CellLattice& lattice, std::span<double> velocity_m_per_s);

}  // namespace telepalp::surface
