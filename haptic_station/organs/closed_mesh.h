#pragma once

#include <array>

#include "support/models/point_model.h"

namespace telepalp::organs {

/// One triangle of a closed mesh, with what tells inside from outside near each of its features.
struct ClosedFace {
  std::array<Eigen::Vector3d, 3> corners;         ///< counter-clockwise from outside [m]
  std::array<Eigen::Vector3d, 3> corner_normals;  ///< angle-weighted over all faces at the corner; of any length
  std::array<Eigen::Vector3d, 3> edge_normals;    ///< of the edge from corner i to i + 1; of any length
  Eigen::Vector3d normal;
};

/// The faces of a closed mesh, looking outwards. Vertices in one place count as one, faces without area as none. An
/// error when an edge has a face on one side only: then nobody can tell inside from outside.
[[nodiscard]] Result<std::vector<ClosedFace>> closed_faces(const models::PointModel& mesh);

/// The point of a face nearest to another, with the normal that tells on which side that other one is.
struct NearestOnFace {
  double squared_m2;
  Eigen::Vector3d at_m;
  const Eigen::Vector3d* normal;
};
[[nodiscard]] NearestOnFace nearest_on(const ClosedFace& face, const Eigen::Vector3d& point_m) noexcept;

}  // namespace telepalp::organs
