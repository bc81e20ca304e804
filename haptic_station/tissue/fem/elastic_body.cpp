#include "haptic_station/tissue/fem/elastic_body.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace telepalp::tissue {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

ElasticBody::ElasticBody(TetMesh mesh, const Lame& material, double density_kg_per_m3)
    : mesh_(std::move(mesh)), material_(material), density_kg_per_m3_(density_kg_per_m3) {
  const auto free = static_cast<Index>(free_nodes());
  rest_.resize(3, free);
  for (Index i = 0; i < free; ++i) rest_.col(i) = mesh_.nodes[mesh_.fixed + static_cast<std::size_t>(i)];
  masses_ = Eigen::VectorXd::Zero(free);
  for (const auto& nodes : mesh_.tetrahedra) {
    add_points(nodes);
    add_masses(nodes);
  }
  make_pattern();
}

/// Gradients of the shape functions, of which those of a quadratic tetrahedron are L (2 L - 1) at its corners and
/// 4 L L' on its edges, with the barycentric coordinates L.
void ElasticBody::add_points(const std::array<std::uint32_t, 10>& nodes) {
  constexpr double kNear = 0.58541019662496852;  // (5 + 3 sqrt 5) / 20: quadrature of degree 2
  constexpr double kFar = 0.13819660112501052;
  Matrix3d edges;
  for (int i = 0; i < 3; ++i)
    edges.col(i) = mesh_.nodes[nodes[static_cast<std::size_t>(i) + 1]] - mesh_.nodes[nodes[0]];
  const double volume_m3 = edges.determinant() / 6.0;
  Eigen::Matrix<double, 3, 4> slopes;  // of the barycentric coordinates
  slopes.rightCols<3>() = edges.inverse().transpose();
  slopes.col(0) = -slopes.rightCols<3>().rowwise().sum();
  const std::size_t count = points_of_each();
  for (std::size_t p = 0; p < count; ++p) {
    Point point{.volume_m3 = volume_m3 / static_cast<double>(count)};
    if (mesh_.order == ElementOrder::Linear) {
      point.gradients.leftCols<4>() = slopes;
    } else {
      Eigen::Vector4d at = Eigen::Vector4d::Constant(kFar);
      at[static_cast<Index>(p)] = kNear;
      for (Index i = 0; i < 4; ++i) point.gradients.col(i) = (4.0 * at[i] - 1.0) * slopes.col(i);
      for (std::size_t e = 0; e < 6; ++e) {
        const auto a = static_cast<Index>(kTetrahedronEdges[e][0]);
        const auto b = static_cast<Index>(kTetrahedronEdges[e][1]);
        point.gradients.col(4 + static_cast<Index>(e)) = 4.0 * (at[a] * slopes.col(b) + at[b] * slopes.col(a));
      }
    }
    points_.push_back(point);
  }
}

void ElasticBody::add_masses(const std::array<std::uint32_t, 10>& nodes) {
  Matrix3d edges;
  for (int i = 0; i < 3; ++i)
    edges.col(i) = mesh_.nodes[nodes[static_cast<std::size_t>(i) + 1]] - mesh_.nodes[nodes[0]];
  const double mass_kg = density_kg_per_m3_ * edges.determinant() / 6.0;
  const bool linear = mesh_.order == ElementOrder::Linear;
  for (std::size_t i = 0; i < nodes_of(mesh_.order); ++i)
    if (nodes[i] >= mesh_.fixed)
      masses_[nodes[i] - static_cast<Index>(mesh_.fixed)] += mass_kg * (linear ? 1.0 / 4 : i < 4 ? 1.0 / 36 : 4.0 / 27);
}

void ElasticBody::make_pattern() {
  const auto count = nodes_of(mesh_.order);
  const auto fixed = static_cast<Index>(mesh_.fixed);
  const auto each_pair = [&](auto&& act) {
    for (const auto& nodes : mesh_.tetrahedra)
      for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b <= a; ++b)
          act(std::max(nodes[a], nodes[b]) - fixed, std::min(nodes[a], nodes[b]) - fixed);
  };
  std::vector<Eigen::Triplet<double>> entries;
  each_pair([&](Index row, Index column) {
    if (column < 0) return;
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 3; ++j)
        entries.emplace_back(static_cast<int>(3 * row + i), static_cast<int>(3 * column + j), 0.0);
  });
  const auto size = static_cast<Index>(3 * free_nodes());
  pattern_.resize(size, size);
  pattern_.setFromTriplets(entries.begin(), entries.end());
  each_pair([&](Index row, Index column) {
    Place place;
    for (Index j = 0; column >= 0 && j < 3; ++j) {
      const int* rows = pattern_.innerIndexPtr();
      const int begin = pattern_.outerIndexPtr()[3 * column + j];
      const int end = pattern_.outerIndexPtr()[3 * column + j + 1];
      place.column[static_cast<std::size_t>(j)] =
          static_cast<int>(std::lower_bound(rows + begin, rows + end, static_cast<int>(3 * row)) - rows);
    }
    places_.push_back(place);
  });
}

ElasticBody::Gradients ElasticBody::corners(std::size_t tetrahedron, const NodeField& at) const {
  Gradients places = Gradients::Zero();
  for (std::size_t i = 0; i < nodes_of(mesh_.order); ++i)
    places.col(static_cast<Index>(i)) = place(mesh_.tetrahedra[tetrahedron][i], at);
  return places;
}

double ElasticBody::energy_J(const NodeField& at) const {
  double sum_J = 0.0;
  for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
    const Gradients places = corners(t, at);
    for (std::size_t p = t * points_of_each(); p < (t + 1) * points_of_each(); ++p) {
      const Corotated law(places * points_[p].gradients.transpose(), material_);
      sum_J += points_[p].volume_m3 * law.energy_J_per_m3();
    }
  }
  return sum_J;
}

void ElasticBody::add_forces(std::size_t tetrahedron, const Gradients& forces_N, NodeField& gradient_N) const {
  for (std::size_t i = 0; i < nodes_of(mesh_.order); ++i)
    if (const std::uint32_t node = mesh_.tetrahedra[tetrahedron][i]; node >= mesh_.fixed)
      gradient_N.col(node - static_cast<Index>(mesh_.fixed)) += forces_N.col(static_cast<Index>(i));
}

void ElasticBody::gradient(const NodeField& at, NodeField& gradient_N) const {
  gradient_N.setZero(3, static_cast<Index>(free_nodes()));
  for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
    const Gradients places = corners(t, at);
    Gradients forces_N = Gradients::Zero();
    for (std::size_t p = t * points_of_each(); p < (t + 1) * points_of_each(); ++p) {
      const Corotated law(places * points_[p].gradients.transpose(), material_);
      forces_N += points_[p].volume_m3 * law.stress_Pa() * points_[p].gradients;
    }
    add_forces(t, forces_N, gradient_N);
  }
}

/// The row of the matrix is that of the node with the larger number, whatever the order in the tetrahedron.
void ElasticBody::add_stiffness(std::size_t tetrahedron, const Point& point, const Corotated& law,
                                double* values) const {
  const auto count = static_cast<Index>(nodes_of(mesh_.order));
  const auto& nodes = mesh_.tetrahedra[tetrahedron];
  const Place* place = &places_[tetrahedron * static_cast<std::size_t>(count * (count + 1) / 2)];
  const Gradients turned = law.v().transpose() * point.gradients;
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b <= a; ++b, ++place) {
      if (place->column[0] < 0) continue;
      Matrix3d block = law.u() * law.turned_block(turned.col(a), turned.col(b)) * law.u().transpose();
      if (nodes[static_cast<std::size_t>(a)] < nodes[static_cast<std::size_t>(b)]) block.transposeInPlace();
      for (Index j = 0; j < 3; ++j)
        for (Index i = 0; i < 3; ++i)
          values[place->column[static_cast<std::size_t>(j)] + i] += point.volume_m3 * block(i, j);
    }
}

void ElasticBody::hessian(const NodeField& at, Curvature curvature, StiffnessMatrix& hessian,
                          NodeField* gradient_N) const {
  std::fill_n(hessian.valuePtr(), hessian.nonZeros(), 0.0);
  if (gradient_N != nullptr) gradient_N->setZero(3, static_cast<Index>(free_nodes()));
  for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
    const Gradients places = corners(t, at);
    Gradients forces_N = Gradients::Zero();
    for (std::size_t p = t * points_of_each(); p < (t + 1) * points_of_each(); ++p) {
      Corotated law(places * points_[p].gradients.transpose(), material_);
      law.prepare(curvature);
      add_stiffness(t, points_[p], law, hessian.valuePtr());
      if (gradient_N != nullptr) forces_N += points_[p].volume_m3 * law.stress_Pa() * points_[p].gradients;
    }
    if (gradient_N != nullptr) add_forces(t, forces_N, *gradient_N);
  }
}

}  // namespace telepalp::tissue
