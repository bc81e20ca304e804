#include "haptic_station/surface/build/body_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kMostBlocks = 1200;            // more would make the fit no better
constexpr std::array kScales_m{0.04, 0.015, 0.008};  // Tukey's, fit after fit: first a wide one, because a body tilts
constexpr double kTiltDoubt = 60.0;   // prior against a tilt, in blocks at half an image's distance: a few blocks in a
                                      // corner say nothing of the rest
constexpr double kFollows_m = 0.015;  // a block that is farther off does not belong to the body

struct Nearer {
  double m;
  Vector3d terms;  ///< 1, column, row from the middle; in units of half the lattice
};

double median_m(const std::vector<Nearer>& blocks) {
  std::vector<double> all;
  all.reserve(blocks.size());
  for (const Nearer& one : blocks) all.push_back(one.m);
  return median_of(all);
}

Vector3d refit(const std::vector<Nearer>& blocks, const Vector3d& before, double scale_m) {
  Matrix3d normal = Vector3d(1e-3, kTiltDoubt, kTiltDoubt).asDiagonal();
  Vector3d right = Vector3d(1e-3 * before[0], 0.0, 0.0);
  for (const Nearer& one : blocks) {
    const double off = (one.m - before.dot(one.terms)) / scale_m;
    if (off * off >= 1.0) continue;
    const double weight = (1.0 - off * off) * (1.0 - off * off);
    normal += weight * one.terms * one.terms.transpose();
    right += weight * one.m * one.terms;
  }
  return normal.ldlt().solve(right);
}

}  // namespace

BodyMotion body_motion(const BlockLattice& lattice, std::span<const float> before_m, std::span<const float> seen_m) {
  BodyMotion motion{.middle_column = 0.5 * (lattice.columns - 1), .middle_row = 0.5 * (lattice.rows - 1)};
  const double half = 0.5 * std::max(lattice.columns, lattice.rows);
  const int step =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(lattice.size()) / kMostBlocks))));
  std::vector<Nearer> blocks;
  for (int row = step / 2; row < lattice.rows; row += step)
    for (int column = step / 2; column < lattice.columns; column += step) {
      const std::size_t at = lattice.at(column, row);
      if (before_m[at] <= 0.0F || seen_m[at] <= 0.0F) continue;
      blocks.push_back({static_cast<double>(before_m[at] - seen_m[at]),
                        {1.0, (column - motion.middle_column) / half, (row - motion.middle_row) / half}});
    }
  motion.off_m = std::numeric_limits<double>::infinity();  // nothing follows it
  if (blocks.empty()) return motion;
  Vector3d fit{median_m(blocks), 0.0, 0.0};
  for (const double scale_m : kScales_m) fit = refit(blocks, fit, scale_m);
  double square = 0.0;
  double count = 1e-9;
  for (const Nearer& one : blocks) {
    const double off_m = one.m - fit.dot(one.terms);
    if (std::abs(off_m) > kFollows_m) continue;
    square += off_m * off_m;
    count += 1.0;
  }
  if (count >= 1.0) motion.off_m = std::sqrt(square / count);
  motion.nearer_m = fit[0];
  motion.per_column_m = fit[1] / half;
  motion.per_row_m = fit[2] / half;
  return motion;
}

}  // namespace telepalp::surface
