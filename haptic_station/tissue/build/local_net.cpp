#include "haptic_station/tissue/build/local_net.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace telepalp::tissue {

using Eigen::Vector3d;

LocalNet::LocalNet(const BaseNet& base, const NetSettings& settings, std::uint32_t contact)
    : settings_(settings),
      base_unknowns_(base.unknowns()),
      vertices_(base.mesh().vertices().begin(), base.mesh().vertices().end()),
      triangles_(base.mesh().triangles().begin(), base.mesh().triangles().end()) {
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    fixed_.push_back(base.unknown(v) < 0 ? 1 : 0);
    shares_.emplace_back();
    if (base.unknown(v) >= 0) shares_[v].push_back({base.unknown(v), 1.0});
  }
  for (int i = 0; i < 3; ++i) corners_[i] = vertices_[triangles_[contact][i]];
  const Vector3d center = (corners_[0] + corners_[1] + corners_[2]) / 3.0;
  const double edge_m = (corners_[1] - corners_[0]).norm();
  vertices_at_[0] = vertices_.size();
  for (int i = 0; i < settings_.subdivisions; ++i) {
    subdivide(center, settings_.spread_m + edge_m / (1 << i));
    vertices_at_[i + 1] = vertices_.size();
  }
  number_unknowns();
  choose_base_unknowns(center, settings_.spread_m + 2.0 * edge_m);
  assemble(base);
}

bool LocalNet::near(const Triangle& triangle, const Vector3d& at_m, double within_m) const {
  return std::ranges::any_of(triangle,
                             [&](std::uint32_t v) { return (vertices_[v] - at_m).norm() < within_m * (1.0 + 1e-9); });
}

bool LocalNet::has_new_vertex(const Triangle& triangle) const {
  return std::ranges::any_of(triangle, [this](std::uint32_t v) { return v >= vertices_at_[0]; });
}

/// Subdivides the triangles that have a corner within `within_m` of `about_m`.
void LocalNet::subdivide(const Vector3d& about_m, double within_m) {
  std::vector<Triangle> next;
  const auto middle = [this](std::uint32_t a, std::uint32_t b) {
    const auto [at, fresh] = middle_of_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices_.size()));
    if (fresh) {
      vertices_.push_back(0.5 * (vertices_[a] + vertices_[b]));
      fixed_.push_back(fixed_[a] != 0 && fixed_[b] != 0 ? 1 : 0);
      ends_of_.emplace_back(a, b);
    }
    return at->second;
  };
  for (const Triangle& t : triangles_) {
    if (!near(t, about_m, within_m)) {
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

/// A vertex in the middle of an edge stays there, without an unknown of its own, if a triangle that was not subdivided
/// has this edge.
void LocalNet::number_unknowns() {
  std::set<Edge> whole;
  for (const Triangle& t : triangles_)
    for (int i = 0; i < 3; ++i) whole.insert(std::minmax(t[i], t[(i + 1) % 3]));
  int added = 0;
  for (int depth = 1; depth <= settings_.subdivisions; ++depth) {
    for (std::size_t v = vertices_at_[depth - 1]; v < vertices_at_[depth]; ++v) {
      const Edge& ends = ends_of_[v - vertices_at_[0]];
      std::vector<Share> shares;
      for (const std::uint32_t end : {ends.first, ends.second})
        for (const Share& share : shares_[end]) shares.push_back({share.unknown, 0.5 * share.weight});
      if (fixed_[v] == 0 && !whole.contains(std::minmax(ends.first, ends.second)))
        shares.push_back({base_unknowns_ + added++, 1.0});
      shares_.push_back(std::move(shares));
    }
    added_at_[depth] = added;
  }
}

/// Chooses the unknowns of the base net that a load or an added unknown touches.
void LocalNet::choose_base_unknowns(const Vector3d& about_m, double within_m) {
  chosen_at_.assign(static_cast<std::size_t>(base_unknowns_), -1);
  for (const Triangle& t : triangles_) {
    if (!has_new_vertex(t) && !near(t, about_m, within_m)) continue;
    for (const std::uint32_t v : t)
      for (const Share& share : shares_[v]) {
        if (share.unknown >= base_unknowns_) continue;
        int& at = chosen_at_[static_cast<std::size_t>(share.unknown)];
        if (at >= 0) continue;
        at = static_cast<int>(chosen_.size());
        chosen_.push_back(share.unknown);
      }
  }
}

/// Place of an unknown among the chosen ones, or among the added ones behind them.
int LocalNet::place(int unknown) const noexcept {
  return unknown < base_unknowns_ ? chosen_at_[static_cast<std::size_t>(unknown)]
                                  : unknown - base_unknowns_ + static_cast<int>(chosen_.size());
}

/// Adds half of the spring on `edge`, which is what one of its triangles has, to the rows of the added unknowns.
void LocalNet::add_spring(const Edge& edge, Eigen::MatrixXd& coupling, Eigen::MatrixXd& own) const {
  std::vector<Share> difference = shares_[edge.first];
  for (const Share& share : shares_[edge.second]) difference.push_back({share.unknown, -share.weight});
  for (const Share& a : difference) {
    if (a.unknown < base_unknowns_) continue;
    for (const Share& b : difference) {
      const double spring = 0.5 * a.weight * b.weight;
      if (b.unknown < base_unknowns_)
        coupling(place(b.unknown), a.unknown - base_unknowns_) += spring;
      else
        own(a.unknown - base_unknowns_, b.unknown - base_unknowns_) += spring;
    }
  }
}

void LocalNet::assemble(const BaseNet& base) {
  const auto chosen = static_cast<Eigen::Index>(chosen_.size());
  const Eigen::Index added = added_at_[settings_.subdivisions];
  Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(chosen, added);
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(added, added);
  for (const Triangle& t : triangles_)
    if (has_new_vertex(t))
      for (int i = 0; i < 3; ++i) add_spring({t[i], t[(i + 1) % 3]}, coupling, own);
  base_ = base.compliance(chosen_);
  carried_ = base_ * coupling;
  added_.compute(own - coupling.transpose() * carried_);
}

/// The share of 1 N on each chosen and each added unknown. The load's density falls as (1 - (r / spread)^2)^2. It is
/// sampled at the points of a fine grid, and each point passes its load on to the corners of its triangle.
Eigen::VectorXd LocalNet::load(const Vector3d& at_m) const {
  constexpr int kRings = 8;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chosen_.size()) + added_.rows());
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
          const double along_m = r.dot(along);
          const double across_m = r.dot(across);
          const double rho2 = (along_m * along_m + across_m * across_m) / (settings_.spread_m * settings_.spread_m);
          if (rho2 >= 1.0) continue;
          const double weight = (1.0 - rho2) * (1.0 - rho2) * (b - a).cross(c - a).norm() / (parts * parts);
          total += weight;
          const std::array<double, 3> parts_of{1.0 - u - v, u, v};
          for (int k = 0; k < 3; ++k)
            for (const Share& share : shares_[t[k]])
              if (const int at = place(share.unknown); at >= 0) load[at] += weight * parts_of[k] * share.weight;
        }
  }
  return total > 0.0 ? Eigen::VectorXd(load / total) : load;
}

std::array<double, LocalNet::kMostDepth + 1> LocalNet::depths(const Vector3d& shares) const {
  const Vector3d at_m = shares[0] * corners_[0] + shares[1] * corners_[1] + shares[2] * corners_[2];
  const Eigen::VectorXd load_N = load(at_m);
  const auto chosen = static_cast<Eigen::Index>(chosen_.size());
  const Eigen::VectorXd own_N = load_N.tail(added_.rows()) - carried_.transpose() * load_N.head(chosen);
  const Eigen::VectorXd parts = added_.matrixL().solve(own_N);
  std::array<double, kMostDepth + 1> depths{};
  const double base = load_N.head(chosen).dot(base_ * load_N.head(chosen));
  for (int depth = 0; depth <= settings_.subdivisions; ++depth)
    depths[depth] = std::max(1e-9, base + parts.head(added_at_[depth]).squaredNorm());
  return depths;
}

/// A halved edge leaves a quarter of the error. So the limit lies beyond the last net by a third of the last change.
double LocalNet::limit(const Vector3d& shares) const {
  const auto at = depths(shares);
  const double last = at[settings_.subdivisions];
  return settings_.subdivisions == 0 ? last : last + (last - at[settings_.subdivisions - 1]) / 3.0;
}

}  // namespace telepalp::tissue
