#include "haptic_station/surface/build/camera_moved.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

constexpr double kPushed_m = 0.012;  // least jump from image to image; a patient who sits up comes 5 mm nearer
constexpr double kDeeper_m = 0.06;
constexpr double kFlat_m = 0.008;        // rms deviation of the bed from a plane
constexpr double kBedSlope_m = 0.004;    // most change of the bed's depth to the next block; a body's flank has more
constexpr std::size_t kLeastShare = 20;  // bed and body each cover at least one part in so many
constexpr int kStep = 3;                 // every ninth block is enough

struct Moved {
  double before_m;
  double nearer_m;
  Eigen::Vector3d terms;  ///< 1, column, row
};

std::vector<Moved> seen_twice(const BlockLattice& lattice, std::span<const float> before_m,
                              std::span<const float> seen_m) {
  std::vector<Moved> all;
  for (int row = 0; row < lattice.rows; row += kStep)
    for (int column = 0; column < lattice.columns; column += kStep) {
      const std::size_t at = lattice.at(column, row);
      if (before_m[at] <= 0.0F || seen_m[at] <= 0.0F) continue;
      all.push_back({before_m[at],
                     static_cast<double>(before_m[at] - seen_m[at]),
                     {1.0, static_cast<double>(column), static_cast<double>(row)}});
    }
  return all;
}

template <class Value>
double median(const std::vector<Moved>& all, const Value& value) {
  std::vector<double> values;
  values.reserve(all.size());
  for (const Moved& one : all) values.push_back(value(one));
  return median_of(values);
}

bool is_flat(const std::vector<Moved>& bed) {
  Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Moved& one : bed) {
    normal += one.terms * one.terms.transpose();
    right += one.before_m * one.terms;
  }
  const Eigen::Vector3d plane = normal.ldlt().solve(right);
  double square = 0.0;
  for (const Moved& one : bed) square += std::pow(one.before_m - plane.dot(one.terms), 2.0);
  return std::sqrt(square / static_cast<double>(bed.size())) <= kFlat_m && plane.tail<2>().norm() <= kBedSlope_m;
}

}  // namespace

bool camera_moved(const BlockLattice& lattice, std::span<const float> before_m, std::span<const float> seen_m) {
  const auto nearer_m = [](const Moved& one) { return one.nearer_m; };
  const std::vector<Moved> all = seen_twice(lattice, before_m, seen_m);
  if (all.empty() || std::abs(median(all, nearer_m)) < kPushed_m) return false;
  const double middle_m = median(all, [](const Moved& one) { return one.before_m; });
  std::vector<Moved> bed;
  std::vector<Moved> body;
  for (const Moved& one : all) (one.before_m > middle_m + kDeeper_m ? bed : body).push_back(one);
  if (bed.size() * kLeastShare < all.size() || body.size() * kLeastShare < all.size() || !is_flat(bed)) return false;
  const double bed_m = median(bed, nearer_m);
  const double body_m = median(body, nearer_m);
  return bed_m * body_m > 0.0 && std::abs(bed_m) > kPushed_m && std::abs(body_m) > kPushed_m;
}

}  // namespace telepalp::surface
