#include "haptic_station/surface/temporal/cell_gains.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/temporal/leaning_mean.h"

namespace telepalp::surface {
namespace {

// A critically damped g-h filter remembers about 1/(1 - theta) frames. The memory is short where the innovations have a
// consistent sign, because the motion changes there. It is long where they are only noise, because a cell's noise moves
// all its pixels together, and the average of the pixels cannot remove it.
constexpr double kQuickTheta = 0.60;
constexpr double kCalmTheta = 0.90;
constexpr double kCellCalmUpTo = 2.5;  // below this mean innovation [sigma] a cell counts as calm
constexpr double kCellQuickFrom = 6.5;
constexpr double kFramesForVelocity = 3.0;  // before this frame, a cell's position is not known well enough
constexpr double kRoughnessLeak = 0.1;      // share of the velocities' roughness removed per frame

}  // namespace

CellGains::CellGains(const CellLattice& lattice)
    : lattice_(lattice), lean_m_(lattice.size(), 0.0), moving_(lattice.size()) {}

/// Finds where the innovations have a consistent sign. It uses neighbourhoods, because a body moves as a whole and
/// noise does not, and because gains that change from cell to cell would make a smooth motion rough.
void CellGains::add(std::span<const CellInnovation> seen, std::span<const CellMean> wide) {
  frames_ += 1.0;
  for (std::size_t at = 0; at < seen.size(); ++at) {
    const double narrower = std::sqrt(seen[at].count / std::max(wide[at].count, 1.0));
    lean_m_[at] += kLeanGain * (wide[at].mean - lean_m_[at]);
    moving_[at] = {leaning(lean_m_[at], narrower * seen[at].sigma_m, kCellCalmUpTo, kCellQuickFrom), seen[at].count};
  }
  moving_ = wide_means(lattice_, moving_);
}

double CellGains::theta(std::size_t cell) const noexcept {
  return kCalmTheta + moving_[cell].mean * (kQuickTheta - kCalmTheta);
}

double CellGains::position(std::size_t cell) const noexcept {
  return std::max(1.0 - theta(cell) * theta(cell), 1.0 / frames_);
}

double CellGains::velocity(std::size_t cell) const noexcept {
  return frames_ < kFramesForVelocity ? 0.0 : (1.0 - theta(cell)) * (1.0 - theta(cell));
}

void smooth_velocities(const CellLattice& lattice, std::span<double> velocity_m_per_s) {
  const std::vector<float> velocity(velocity_m_per_s.begin(), velocity_m_per_s.end());
  const std::vector<float> means = means_of(lattice, velocity);
  std::vector<CellMean> whole(means.size());
  std::transform(means.begin(), means.end(), whole.begin(), [](float mean) {
    return CellMean{static_cast<double>(mean), CellLattice::kCell_px * CellLattice::kCell_px};
  });
  const std::vector<float> smooth = smooth_coefficients(lattice, whole);
  for (std::size_t at = 0; at < velocity_m_per_s.size(); ++at)
    velocity_m_per_s[at] += kRoughnessLeak * (static_cast<double>(smooth[at]) - velocity_m_per_s[at]);
}

}  // namespace telepalp::surface
