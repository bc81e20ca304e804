#include "haptic_station/tissue/build/local_net.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace telepalp::tissue {

using Eigen::Vector3d;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

LocalNet::LocalNet(const SurfaceMesh& mesh, const NetSettings& settings, std::uint32_t contact)
    : settings_(settings),
      vertices_(mesh.vertices().begin(), mesh.vertices().end()),
      triangles_(mesh.triangles().begin(), mesh.triangles().end()) {
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) fixed_.push_back(mesh.on_rim(v) ? 1 : 0);
  for (int i = 0; i < 3; ++i) corners_[i] = vertices_[triangles_[contact][i]];
  const Vector3d center = (corners_[0] + corners_[1] + corners_[2]) / 3.0;
  const double edge_m = (corners_[1] - corners_[0]).norm();
  for (int i = 0; i < settings_.subdivisions; ++i) subdivide(center, settings_.spread_m + edge_m / (1 << i));
  number_unknowns();
  assemble();
}

/// Subdivides the triangles that have a corner within `within_m` of `about_m`.
void LocalNet::subdivide(const Vector3d& about_m, double within_m) {
  std::vector<Triangle> next;
  const auto middle = [this](std::uint32_t a, std::uint32_t b) {
    const auto [at, fresh] = middle_of_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices_.size()));
    if (fresh) {
      vertices_.push_back(0.5 * (vertices_[a] + vertices_[b]));
      fixed_.push_back(fixed_[a] != 0 && fixed_[b] != 0 ? 1 : 0);
    }
    return at->second;
  };
  for (const Triangle& t : triangles_) {
    const bool near = std::ranges::any_of(
        t, [&](std::uint32_t v) { return (vertices_[v] - about_m).norm() < within_m * (1.0 + 1e-9); });
    if (!near) {
      next.push_back(t);
      continue;
    }
    const std::uint32_t ab = middle(t[0], t[1]);
    const std::uint32_t bc = middle(t[1], t[2]);
    const std::uint32_t ca = middle(t[2], t[0]);
    next.insert(next.end(), {Triangle{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
  }
  triangles_ = std::move(next);
}

/// A vertex in the middle of an edge moves with both ends of the edge if a triangle that was not subdivided has this
/// edge.
void LocalNet::number_unknowns() {
  std::set<Edge> whole;
  for (const Triangle& t : triangles_)
    for (int i = 0; i < 3; ++i) whole.insert(std::minmax(t[i], t[(i + 1) % 3]));
  std::map<std::uint32_t, Edge> follows;
  for (const auto& [edge, middle] : middle_of_)
    if (whole.contains(edge)) follows[middle] = edge;
  shares_.resize(vertices_.size());
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    if (fixed_[v] != 0) continue;
    const auto ends = follows.find(v);
    if (ends == follows.end()) {
      shares_[v] = {{unknowns_++, 1.0}};
      continue;
    }
    for (const std::uint32_t end : {ends->second.first, ends->second.second})
      for (const Share& share : shares_[end]) shares_[v].push_back({share.unknown, 0.5 * share.weight});
  }
}

/// Each triangle has half of the spring on each of its edges.
void LocalNet::assemble() {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& t : triangles_)
    for (int i = 0; i < 3; ++i) {
      std::vector<Share> difference = shares_[t[i]];
      for (const Share& share : shares_[t[(i + 1) % 3]]) difference.push_back({share.unknown, -share.weight});
      for (const Share& a : difference)
        for (const Share& b : difference) entries.emplace_back(a.unknown, b.unknown, 0.5 * a.weight * b.weight);
    }
  Eigen::SparseMatrix<double> stiffness(unknowns_, unknowns_);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  solver_.compute(stiffness);
}

/// The share of 1 N on each unknown. The load's density falls as (1 - (r / spread)^2)^2. It is sampled at the points of
/// a fine grid, and each point passes its load on to the corners of its triangle.
Eigen::VectorXd LocalNet::load(const Vector3d& at_m) const {
  constexpr int kRings = 8;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns_);
  const Vector3d normal = (corners_[1] - corners_[0]).cross(corners_[2] - corners_[0]).normalized();
  const Vector3d along = (corners_[1] - corners_[0]).normalized();
  const Vector3d across = normal.cross(along);
  double total = 0.0;
  for (const Triangle& t : triangles_) {
    const Vector3d& a = vertices_[t[0]];
    const Vector3d& b = vertices_[t[1]];
    const Vector3d& c = vertices_[t[2]];
    const double far_m = ((a + b + c) / 3.0 - at_m).norm() - (b - a).norm();
    if (far_m > settings_.spread_m) continue;
    // A triangle is cut into small ones, and the density is taken at their middles.
    const int parts = std::max(1, static_cast<int>(std::ceil(kRings * (b - a).norm() / settings_.spread_m)));
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j)
        for (int flipped = 0; flipped < (i + j + 1 < parts ? 2 : 1); ++flipped) {
          const double u = (i + (1 + flipped) / 3.0) / parts;
          const double v = (j + (1 + flipped) / 3.0) / parts;
          const Vector3d r = a + u * (b - a) + v * (c - a) - at_m;
          const double rho2 =
              (std::pow(r.dot(along), 2) + std::pow(r.dot(across), 2)) / std::pow(settings_.spread_m, 2);
          if (rho2 >= 1.0) continue;
          const double weight = (1.0 - rho2) * (1.0 - rho2) * (b - a).cross(c - a).norm() / (parts * parts);
          total += weight;
          const std::array<double, 3> parts_of{1.0 - u - v, u, v};
          for (int k = 0; k < 3; ++k)
            for (const Share& share : shares_[t[k]]) load[share.unknown] += weight * parts_of[k] * share.weight;
        }
  }
  return total > 0.0 ? Eigen::VectorXd(load / total) : load;
}

double LocalNet::compliance(const Vector3d& shares) const {
  const Vector3d at_m = shares[0] * corners_[0] + shares[1] * corners_[1] + shares[2] * corners_[2];
  const Eigen::VectorXd load_N = load(at_m);
  return std::max(1e-9, load_N.dot(solver_.solve(load_N)));
}

}  // namespace telepalp::tissue
