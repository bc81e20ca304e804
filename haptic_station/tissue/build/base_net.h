#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "haptic_station/tissue/mesh/surface_mesh.h"

namespace telepalp::tissue {

/// The net of springs of 1 N/m along the edges of a mesh, before any subdivision; vertices on the rim are fixed. Each
/// triangle has half of the spring on each of its edges. Solved once for all contacts. Allocates.
class BaseNet {
 public:
  explicit BaseNet(const SurfaceMesh& mesh);
  [[nodiscard]] const SurfaceMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] int unknowns() const noexcept { return unknowns_; }
  /// Index of a vertex's displacement; -1: the vertex is fixed.
  [[nodiscard]] int unknown(std::uint32_t vertex) const noexcept { return unknown_[vertex]; }
  /// Displacements of `unknowns` (rows) by 1 N on each of them (columns) [m]; N x N.
  [[nodiscard]] Eigen::MatrixXd compliance(std::span<const int> unknowns) const;

 private:
  const SurfaceMesh* mesh_;
  std::vector<int> unknown_;
  int unknowns_ = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace telepalp::tissue
