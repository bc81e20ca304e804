#pragma once

#include <array>

#include "support/models/point_model.h"

namespace telepalp::organs {

/// One triangle of a closed mesh, with the pseudo-normals of its corners, edges and face. The pseudo-normals tell
/// inside from outside.
struct ClosedFace {
  std::array<Eigen::Vector3d, 3> corners;         ///< counter-clockwise from outside [m]
  std::array<Eigen::Vector3d, 3> corner_normals;  ///< angle-weighted sum over all faces at the corner; not normalised
  std::array<Eigen::Vector3d, 3> edge_normals;    ///< pseudo-normal of the edge from corner i to i + 1; not normalised
  Eigen::Vector3d normal;                         ///< unit; zero for a face without area
};

/// The faces of a closed mesh with outward normals; a mesh whose faces all look inwards is turned inside out. Vertices
/// at equal positions are merged; triangles that lose a corner by this are dropped. Error: an edge is not traversed
/// equally often in both directions by its faces, so inside and outside are undefined; no face, a volume of 1 mm³ or
/// less, or a corner that is not finite.
[[nodiscard]] Result<std::vector<ClosedFace>> closed_faces(const models::PointModel& mesh);

/// The point of a face nearest to a query, its squared distance, and the pseudo-normal there, which the face owns. The
/// scalar product of the pseudo-normal with the vector from this point to the query is negative inside.
struct NearestOnFace {
  double squared_m2;
  Eigen::Vector3d at_m;
  const Eigen::Vector3d* normal;
};
[[nodiscard]] NearestOnFace nearest_on(const ClosedFace& face, const Eigen::Vector3d& point_m) noexcept;

}  // namespace telepalp::organs
