#include "tests/bench/accuracy/accuracy_spring_prism.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <set>
#include <utility>

namespace telepalp::bench {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using tissue::Patch;
using tissue::TetMesh;

Patch half_of(const TetMesh& mesh) {
  return tissue::patch_around(mesh, tissue::PrismSide::Right, {0.01, 0.05, 0.0}, 0.008);
}

/// The stiffness of the free nodes, by axes as in StiffnessMatrix.
tissue::StiffnessMatrix stiffness_of_springs(const TetMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& tetrahedron : mesh.tetrahedra)
    for (const auto& [a, b] : tissue::kTetrahedronEdges) edges.insert(std::minmax(tetrahedron[a], tetrahedron[b]));
  const auto fixed = static_cast<Index>(mesh.fixed);
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [from, to] : edges) {
    const Vector3d along = (mesh.nodes[to] - mesh.nodes[from]).normalized();
    const Index ends[]{static_cast<Index>(from) - fixed, static_cast<Index>(to) - fixed};
    for (const Index row : ends)
      for (const Index column : ends)
        for (Index i = 0; row >= 0 && column >= 0 && i < 3; ++i)
          for (Index j = 0; j < 3; ++j)
            entries.emplace_back(static_cast<int>(3 * row + i), static_cast<int>(3 * column + j),
                                 (row == column ? 1.0 : -1.0) * along[i] * along[j]);
  }
  const auto size = static_cast<Index>(3 * (mesh.nodes.size() - mesh.fixed));
  tissue::StiffnessMatrix stiffness(size, size);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

}  // namespace

PrismCompliance compliance_of(const std::shared_ptr<const tissue::ElasticBody>& body) {
  tissue::ElasticMotion at_rest(body, 0.0);
  return {.top = at_rest.compliance_m_per_N(tissue::top_of(body->mesh()), Vector3d::UnitX()),
          .half = at_rest.compliance_m_per_N(half_of(body->mesh()), Vector3d::UnitX())};
}

PrismCompliance compliance_of_springs(const tissue::PrismGrid& grid) {
  const TetMesh mesh = *tissue::make_prism(grid);
  const Eigen::SimplicialLDLT<tissue::StiffnessMatrix> solver(stiffness_of_springs(mesh));
  const auto compliance = [&](const Patch& patch) {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(solver.rows());
    for (const auto& [node, share] : patch.shares) load[3 * static_cast<Index>(node)] += share;
    return load.dot(solver.solve(load));
  };
  return {.top = compliance(tissue::top_of(mesh)), .half = compliance(half_of(mesh))};
}

}  // namespace telepalp::bench
