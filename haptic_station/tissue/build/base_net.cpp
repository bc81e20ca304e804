#include "haptic_station/tissue/build/base_net.h"

namespace telepalp::tissue {

BaseNet::BaseNet(const SurfaceMesh& mesh) : mesh_(&mesh) {
  for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) unknown_.push_back(mesh.on_rim(v) ? -1 : unknowns_++);
  if (unknowns_ == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& t : mesh.triangles())
    for (int i = 0; i < 3; ++i) {
      const int a = unknown_[t[i]];
      const int b = unknown_[t[(i + 1) % 3]];
      if (a >= 0) entries.emplace_back(a, a, 0.5);
      if (b >= 0) entries.emplace_back(b, b, 0.5);
      if (a < 0 || b < 0) continue;
      entries.emplace_back(a, b, -0.5);
      entries.emplace_back(b, a, -0.5);
    }
  Eigen::SparseMatrix<double> stiffness(unknowns_, unknowns_);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  solver_.compute(stiffness);
}

Eigen::MatrixXd BaseNet::compliance(std::span<const int> unknowns) const {
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  if (count == 0) return Eigen::MatrixXd(0, 0);
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(unknowns_, count);
  for (Eigen::Index i = 0; i < count; ++i) loads(unknowns[static_cast<std::size_t>(i)], i) = 1.0;
  const Eigen::MatrixXd moved = solver_.solve(loads);
  Eigen::MatrixXd chosen(count, count);
  for (Eigen::Index i = 0; i < count; ++i) chosen.row(i) = moved.row(unknowns[static_cast<std::size_t>(i)]);
  return chosen;
}

}  // namespace telepalp::tissue
