#pragma once

#include <Eigen/Core>
#include <span>

namespace telepalp::isosurface {

/// A plane through `at` with the unit normal `normal`.
struct Plane {
  Eigen::Vector3d at;
  Eigen::Vector3d normal;
};

/// Where planes meet, by least squares.
struct Meeting {
  Eigen::Vector3d at;
  int rank;        ///< 1: the planes are alike; 2: they meet in a line; 3: in a point
  double worst_m;  ///< largest distance from `at` to a plane
};

/// The point nearest to all planes that is also nearest to the mean of their points: directions in which the planes
/// hardly differ are left out (Kobbelt, Botsch, Schwanecke and Seidel 2001). `most_rank`: 0 to 3, directions used at
/// most.
[[nodiscard]] Meeting meeting_of(std::span<const Plane> planes, int most_rank = 3);

}  // namespace telepalp::isosurface
