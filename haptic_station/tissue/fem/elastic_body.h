#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "haptic_station/tissue/fem/corotated.h"
#include "haptic_station/tissue/fem/prism_mesh.h"

namespace telepalp::tissue {

/// Places or velocities of the nodes that are free, one column each.
using NodeField = Eigen::Matrix3Xd;
/// Rows and columns: the three axes of the first free node, of the second, and so on.
using StiffnessMatrix = Eigen::SparseMatrix<double>;

/// A body of corotational tetrahedra: its elastic energy as a function of the places of its free nodes, with the exact
/// first and second derivatives. Integrated at one point of a linear tetrahedron and at four of a quadratic one, which
/// is exact for small displacements. Immutable.
class ElasticBody {
 public:
  /// `mesh` must pass check().
  ElasticBody(TetMesh mesh, const Lame& material, double density_kg_per_m3);

  [[nodiscard]] std::size_t free_nodes() const noexcept { return mesh_.nodes.size() - mesh_.fixed; }
  [[nodiscard]] const TetMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const NodeField& rest() const noexcept { return rest_; }
  /// Mass of each free node [kg]: the diagonal of the consistent mass matrix, scaled to the body's mass (Hinton, Rock,
  /// Zienkiewicz 1976); the nodes of a quadratic tetrahedron would get negative masses from its rows' sums.
  [[nodiscard]] const Eigen::VectorXd& masses() const noexcept { return masses_; }

  [[nodiscard]] double energy_J(const NodeField& at) const;
  /// Sets `gradient_N` to the derivative of the energy: minus the elastic force on each free node.
  void gradient(const NodeField& at, NodeField& gradient_N) const;
  /// A matrix of zeros in whose places hessian() writes. Only the lower half is meaningful.
  [[nodiscard]] const StiffnessMatrix& pattern() const noexcept { return pattern_; }
  /// Sets `hessian` to the second derivative [N/m]; it must be a copy of pattern(). `gradient_N`: set as by gradient(),
  /// at little further cost; nullptr: not wanted.
  void hessian(const NodeField& at, Curvature curvature, StiffnessMatrix& hessian,
               NodeField* gradient_N = nullptr) const;

  /// Place of node `node` of the mesh, fixed or free.
  [[nodiscard]] Eigen::Vector3d place(std::uint32_t node, const NodeField& at) const {
    return node < mesh_.fixed ? mesh_.nodes[node]
                              : Eigen::Vector3d(at.col(node - static_cast<Eigen::Index>(mesh_.fixed)));
  }

 private:
  using Gradients = Eigen::Matrix<double, 3, 10>;
  /// A point at which the energy is summed.
  struct Point {
    Gradients gradients = Gradients::Zero();  ///< of the shape functions [1/m]
    double volume_m3 = 0.0;
  };
  void add_points(const std::array<std::uint32_t, 10>& nodes);
  void add_masses(const std::array<std::uint32_t, 10>& nodes);
  void make_pattern();
  [[nodiscard]] std::size_t points_of_each() const noexcept { return mesh_.order == ElementOrder::Linear ? 1 : 4; }
  void add_forces(std::size_t tetrahedron, const Gradients& forces_N, NodeField& gradient_N) const;
  void add_stiffness(std::size_t tetrahedron, const Point& point, const Corotated& law, double* values) const;
  [[nodiscard]] Gradients corners(std::size_t tetrahedron, const NodeField& at) const;

  TetMesh mesh_;
  Lame material_;
  double density_kg_per_m3_;
  NodeField rest_;
  Eigen::VectorXd masses_;
  std::vector<Point> points_;  ///< of the first tetrahedron, of the second, and so on
  StiffnessMatrix pattern_;
  /// Where the columns of the 3 x 3 block of two nodes of a tetrahedron begin in the matrix's values; -1: one of the
  /// nodes is fixed. In the order in which hessian() meets the pairs.
  struct Place {
    std::array<int, 3> column{-1, -1, -1};
  };
  std::vector<Place> places_;
};

}  // namespace telepalp::tissue
