#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "haptic_station/tissue/net/stiffness_map.h"

namespace telepalp::tissue {

/// The net of springs of 1 N/m that is subdivided around one contact triangle (StiffnessMap). Allocates.
class LocalNet {
 public:
  LocalNet(const SurfaceMesh& mesh, const NetSettings& settings, std::uint32_t contact);
  /// The displacement of the tip by 1 N [m]. `shares`: barycentric coordinates in the contact triangle.
  [[nodiscard]] double compliance(const Eigen::Vector3d& shares) const;

 private:
  struct Share {
    int unknown;
    double weight;
  };
  void subdivide(const Eigen::Vector3d& about_m, double within_m);
  void number_unknowns();
  void assemble();
  [[nodiscard]] Eigen::VectorXd load(const Eigen::Vector3d& at_m) const;

  NetSettings settings_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint8_t> fixed_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_of_;  ///< vertex in the middle of an edge
  std::vector<std::vector<Share>> shares_;  ///< of each vertex: the unknowns that its displacement follows
  std::array<Eigen::Vector3d, 3> corners_;
  int unknowns_ = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace telepalp::tissue
