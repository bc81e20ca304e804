#include "haptic_station/tissue/fem/prism_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic_station/tissue/fem/prism_model.h"
#include "haptic_station/tissue/mesh/nearest_shares.h"

namespace telepalp::tissue {

using Eigen::Vector3d;

PrismSurface::PrismSurface(const ElasticBody& body) : body_(body) {
  for (std::size_t side = 0; side < kPrismSides; ++side)
    sides_[side] = flat_triangles(body.mesh(), static_cast<PrismSide>(side));
}

SidePoint PrismSurface::nearest(const Triangle& triangle, const Vector3d& tool_m, const NodeField& at) const {
  std::array<Vector3d, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = body_.place(triangle[i], at);
  const Vector3d shares = nearest_shares(tool_m, corner[0], corner[1], corner[2]);
  SidePoint point;
  for (std::size_t i = 0; i < 3; ++i) {
    point.at_m += shares[static_cast<Eigen::Index>(i)] * corner[i];
    point.rest_m += shares[static_cast<Eigen::Index>(i)] * body_.mesh().nodes[triangle[i]];
  }
  point.normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
  point.behind_m = point.normal.dot(point.at_m - tool_m);
  point.away_m = (point.at_m - tool_m).norm();
  return point;
}

SidePoints PrismSurface::nearest(const Vector3d& tool_m, const NodeField& at) const {
  SidePoints best;
  for (std::size_t side = 0; side < kPrismSides; ++side) {
    best[side].away_m = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : sides_[side])
      if (const SidePoint point = nearest(triangle, tool_m, at); point.away_m < best[side].away_m) best[side] = point;
  }
  return best;
}

Vector3d PrismSurface::normal_around(PrismSide side, const Vector3d& rest_m, double radius_m,
                                     const NodeField& at) const {
  Vector3d sum = Vector3d::Zero();
  for (const Triangle& triangle : sides_[static_cast<std::size_t>(side)]) {
    std::array<Vector3d, 3> corner;
    Vector3d middle_m = Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = body_.place(triangle[i], at);
      middle_m += body_.mesh().nodes[triangle[i]] / 3.0;
    }
    const double weight = std::exp(-(middle_m - rest_m).squaredNorm() / (radius_m * radius_m));
    sum += weight * (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  }
  return sum.normalized();
}

bool is_inside(const SidePoints& sides, const Vector3d& tool_m) noexcept {
  return tool_m.y() > 0.0 && std::ranges::all_of(sides, [](const SidePoint& side) { return side.behind_m > 0.0; });
}

}  // namespace telepalp::tissue
