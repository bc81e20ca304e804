#include "haptic_station/tissue/fem/prism_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

using Shares = Eigen::Matrix<double, 6, 1>;

/// Values of the shape functions of a side's triangle at barycentric coordinates `at`.
Shares shares_at(ElementOrder order, const Vector3d& at) {
  Shares shares = Shares::Zero();
  if (order == ElementOrder::Linear) {
    shares.head<3>() = at;
    return shares;
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    shares[i] = at[i] * (2.0 * at[i] - 1.0);
    shares[3 + i] = 4.0 * at[i] * at[(i + 1) % 3];
  }
  return shares;
}

/// Calls `act` with the barycentric coordinates of the middle of each of 64 equal parts of a triangle.
template <class Act>
void each_part(const Act& act) {
  constexpr int kParts = 8;
  constexpr double kSide = 1.0 / kParts;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; i + j < kParts; ++j) {
      const auto part = [&](double third) {
        const double a = (i + third) * kSide;
        const double b = (j + third) * kSide;
        act(Vector3d(a, b, 1.0 - a - b));
      };
      part(1.0 / 3.0);
      if (i + j + 1 < kParts) part(2.0 / 3.0);
    }
}

/// The patch in which each point of a side has the weight `weight(place at rest)`.
template <class Weight>
Patch weighted(const TetMesh& mesh, PrismSide side, const Weight& weight) {
  std::map<std::uint32_t, double> shares;
  double sum = 0.0;
  for (const SideTriangle& nodes : mesh.sides[static_cast<std::size_t>(side)]) {
    const Vector3d& a = mesh.nodes[nodes[0]];
    const Vector3d& b = mesh.nodes[nodes[1]];
    const Vector3d& c = mesh.nodes[nodes[2]];
    const double area = (b - a).cross(c - a).norm();
    each_part([&](const Vector3d& at) {
      const double here = area * weight(at[0] * a + at[1] * b + at[2] * c);
      if (here == 0.0) return;
      const Shares given = shares_at(mesh.order, at);
      for (std::size_t i = 0; i < (mesh.order == ElementOrder::Linear ? 3U : 6U); ++i)
        shares[nodes[i]] += here * given[static_cast<Eigen::Index>(i)];
      sum += here;
    });
  }
  Patch patch;
  for (const auto& [node, share] : shares) {
    if (node < mesh.fixed)
      patch.fixed_m += share / sum * mesh.nodes[node];
    else
      patch.shares.emplace_back(node - static_cast<std::uint32_t>(mesh.fixed), share / sum);
  }
  return patch;
}

struct Check {
  std::optional<Error> error;
  void number(const char* name, double value, const Limit& limit) {
    if (error || (value >= limit.least && value <= limit.most)) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s is %g %s", name, value, limit.unit);
    char fix[100];
    std::snprintf(fix, sizeof fix, "give %g to %g %s", limit.least, limit.most, limit.unit);
    error = Error{.what = text, .where = "prism", .fix = fix};
  }
};

std::optional<Error> fault_of(const PrismSettings& settings) {
  Check check;
  for (const double size_m : settings.grid.size_m) check.number("a side of size_m", size_m, limits::kSize_m);
  for (const double at_m : settings.foot_m) check.number("foot_m", at_m, limits::kAt_m);
  check.number("across", settings.grid.across, limits::kAcross);
  check.number("along", settings.grid.along, limits::kAlong);
  check.number("top_N_per_m", settings.top_N_per_m, limits::kTop_N_per_m);
  check.number("poisson", settings.poisson, limits::kPoisson);
  check.number("density_kg_per_m3", settings.density_kg_per_m3, limits::kDensity_kg_per_m3);
  check.number("damping_per_s", settings.damping_per_s, limits::kDamping_per_s);
  check.number("spread_m", settings.spread_m, limits::kPrismSpread_m);
  if (settings.coupling_N_per_m != 0.0)
    check.number("coupling_N_per_m", settings.coupling_N_per_m, limits::kCoupling_N_per_m);
  check.number("lets_go_N", settings.lets_go_N, limits::kLetsGo_N);
  return check.error;
}

}  // namespace

Patch top_of(const TetMesh& mesh) {
  return weighted(mesh, PrismSide::Top, [](const Vector3d&) { return 1.0; });
}

Patch patch_around(const TetMesh& mesh, PrismSide side, const Vector3d& center_m, double radius_m) {
  // At least some of the points at which a coarse mesh is summed must be in the patch.
  const SideTriangle& first = mesh.sides[static_cast<std::size_t>(side)].front();
  const double longest_m =
      (mesh.nodes[first[1]] - mesh.nodes[first[0]]).norm() + (mesh.nodes[first[2]] - mesh.nodes[first[1]]).norm();
  const double reach_m = std::max(radius_m, 0.25 * longest_m);
  return weighted(mesh, side, [&](const Vector3d& at_m) {
    const double left = std::max(0.0, 1.0 - (at_m - center_m).squaredNorm() / (reach_m * reach_m));
    return left * left;
  });
}

double top_stiffness_N_per_m(const std::shared_ptr<const ElasticBody>& body) {
  ElasticMotion at_rest(body, 0.0);
  return 1.0 / at_rest.compliance_m_per_N(top_of(body->mesh()), Vector3d::UnitX());
}

std::vector<std::array<std::uint32_t, 3>> flat_triangles(const TetMesh& mesh, PrismSide side) {
  std::vector<std::array<std::uint32_t, 3>> flat;
  for (const SideTriangle& n : mesh.sides[static_cast<std::size_t>(side)]) {
    if (mesh.order == ElementOrder::Linear) {
      flat.push_back({n[0], n[1], n[2]});
      continue;
    }
    flat.push_back({n[0], n[3], n[5]});
    flat.push_back({n[3], n[1], n[4]});
    flat.push_back({n[5], n[4], n[2]});
    flat.push_back({n[3], n[4], n[5]});
  }
  return flat;
}

Result<std::shared_ptr<const PrismModel>> make_prism_model(const PrismSettings& settings) {
  if (const auto fault = fault_of(settings)) return *fault;
  Result<TetMesh> mesh = make_prism(settings.grid);
  if (!mesh) return mesh.error();
  if (auto right = check(*mesh); !right) return right.error();
  const double density = settings.density_kg_per_m3;
  const auto unit = std::make_shared<const ElasticBody>(*mesh, lame(1.0, settings.poisson), density);
  const double young_Pa = settings.top_N_per_m / top_stiffness_N_per_m(unit);
  return std::make_shared<const PrismModel>(PrismModel{
      .settings = settings,
      .young_Pa = young_Pa,
      .body = std::make_shared<const ElasticBody>(std::move(*mesh), lame(young_Pa, settings.poisson), density)});
}

}  // namespace telepalp::tissue
