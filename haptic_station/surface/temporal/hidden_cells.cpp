#include "haptic_station/surface/temporal/hidden_cells.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace telepalp::surface {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kCellFollows_m = 0.006;  // a cell that moved more beside the body does not count
constexpr double kShiftDoubt = 4.0;       // prior, in cells: with fewer, the body's shared motion alone counts
constexpr double kCellTiltDoubt = 15.0;   // the same, against a tilt, which a few cells in a corner do not tell

/// 1, column and row from the image's middle, in units of half the lattice.
Vector3d place_of(const CellLattice& lattice, std::size_t at) noexcept {
  const auto columns = static_cast<std::size_t>(lattice.columns);
  const double half = 0.5 * lattice.columns;
  return {1.0, (static_cast<double>(at % columns) - 0.5 * (lattice.columns - 1)) / half,
          (static_cast<double>(at / columns) - 0.5 * (lattice.rows - 1)) / half};
}

}  // namespace

void fill_hidden(const CellLattice& lattice, std::span<const std::uint8_t> hidden, std::span<const double> shared_m,
                 std::span<CellInnovation> seen) {
  if (hidden.empty()) return;
  Matrix3d normal = Vector3d(kShiftDoubt, kCellTiltDoubt, kCellTiltDoubt).asDiagonal();
  Vector3d right = Vector3d::Zero();
  double sigma_m = 0.0;
  double count = 1e-9;
  for (std::size_t at = 0; at < seen.size(); ++at) {
    if (hidden[at] != 0 || seen[at].count < kLeastCount) continue;
    const double off_m = seen[at].mean_m - shared_m[at];
    if (std::abs(off_m) > kCellFollows_m) continue;
    const Vector3d place = place_of(lattice, at);
    normal += place * place.transpose();
    right += off_m * place;
    sigma_m += seen[at].sigma_m;
    count += 1.0;
  }
  const Vector3d plane = normal.ldlt().solve(right);
  for (std::size_t at = 0; at < seen.size(); ++at)
    if (hidden[at] != 0)
      seen[at] = {.mean_m = shared_m[at] + plane.dot(place_of(lattice, at)),
                  .count = CellLattice::kCell_px * CellLattice::kCell_px,
                  .sigma_m = sigma_m / count};
}

}  // namespace telepalp::surface
