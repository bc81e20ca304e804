#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "haptic_station/device/random.h"
#include "haptic_station/tissue/build/local_net.h"
#include "haptic_station/tissue/mesh/surface_mesh.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

std::uint32_t middle_of(const SurfaceMesh& mesh) {
  std::uint32_t best = 0;
  double least_m = 1.0;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    Vector3d sum = Vector3d::Zero();
    for (const std::uint32_t v : mesh.triangles()[t]) sum += mesh.vertices()[v] / 3.0;
    if (sum.norm() < least_m) least_m = sum.norm(), best = t;
  }
  return best;
}

const Vector3d kPlaces[]{{1.0 / 3, 1.0 / 3, 1.0 / 3}, {1, 0, 0}, {0.5, 0.5, 0}, {0.7, 0.2, 0.1}};

/// The coarse net of the scenes. Without extrapolation, the second subdivision makes it softer by 0.7 %, and the first
/// one by 2.7 %.
TEST(StiffnessMap, AFurtherSubdivisionChangesTheForceByAtMostATenthOfAPercent) {
  const SurfaceMesh mesh = lattice_disc(0.06, 0.0075);
  const BaseNet base(mesh);
  const LocalNet net(base, {.subdivisions = 2}, middle_of(mesh));
  for (const Vector3d& at : kPlaces) {
    const double once = net_compliance(mesh, {.subdivisions = 1}, middle_of(mesh), at);
    EXPECT_NEAR(net.limit(at) / once, 1.0, 0.001);
    EXPECT_GT(net.compliance(at, 1) / net.compliance(at, 0), 1.02);
    EXPECT_GT(net.compliance(at, 2) / net.compliance(at, 1), 1.004);
  }
}

/// Before the extrapolation, each depth is the net of springs itself: solved here without hierarchical unknowns, as one
/// sparse system on a mesh that is subdivided everywhere.
TEST(StiffnessMap, ASubdividedNetIsTheNetOfItsChildren) {
  const SurfaceMesh coarse = lattice_disc(0.02, 0.005);
  std::vector<Vector3d> vertices(coarse.vertices().begin(), coarse.vertices().end());
  std::vector<Triangle> triangles;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices.size()));
    if (fresh) vertices.push_back(0.5 * (vertices[a] + vertices[b]));
    return at->second;
  };
  for (const Triangle& t : coarse.triangles()) {
    const std::uint32_t ab = middle(t[0], t[1]);
    const std::uint32_t bc = middle(t[1], t[2]);
    const std::uint32_t ca = middle(t[2], t[0]);
    triangles.insert(triangles.end(), {Triangle{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
  }
  const std::uint32_t contact = middle_of(coarse);
  const Result<SurfaceMesh> fine = make_mesh(vertices, triangles);
  ASSERT_TRUE(fine.ok());
  const NetSettings once{.spread_m = 0.012, .subdivisions = 1};  // each triangle has a corner near enough
  const NetSettings whole{.spread_m = 0.012, .subdivisions = 0};
  const BaseNet on_coarse(coarse);
  const BaseNet on_fine(*fine);
  const LocalNet by_levels(on_coarse, once, contact);
  const LocalNet direct(on_fine, whole, 4 * contact + 3);  // the middle child
  const Vector3d middle_of_child(1.0 / 3, 1.0 / 3, 1.0 / 3);
  EXPECT_NEAR(by_levels.compliance(kPlaces[0], 1) / direct.compliance(middle_of_child, 0), 1.0, 1e-3);
  EXPECT_GT(by_levels.compliance(kPlaces[0], 1) / by_levels.compliance(kPlaces[0], 0), 1.01);
}

/// A membrane of tension T and radius R under a load spread over r: with springs k of an equilateral lattice, T is
/// k sqrt(3), because half of the energy of each spring belongs to each of its two triangles.
TEST(StiffnessMap, TheNetIsAMembraneUnderTension) {
  const double radius_m = 0.06;
  const double spread_m = 0.012;
  const SurfaceMesh mesh = lattice_disc(radius_m, 0.006);
  double clamped_m = 0.0;  // mean radius of the rim
  int rim = 0;
  for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v)
    if (mesh.on_rim(v)) clamped_m += mesh.vertices()[v].norm(), ++rim;
  clamped_m /= rim;
  // Compliance of density (1 - rho^2)^2 by energy: integral of Q(r)^2 / (2 pi T r), Q the load inside r.
  double integral = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double r = (i + 0.5) * clamped_m / 20000;
    const double rho2 = std::min(1.0, r * r / (spread_m * spread_m));
    const double inside = 1.0 - std::pow(1.0 - rho2, 3);
    integral += inside * inside / r * clamped_m / 20000;
  }
  const double wanted = integral / (2.0 * std::numbers::pi * std::sqrt(3.0));
  EXPECT_NEAR(net_compliance(mesh, {.spread_m = spread_m, .subdivisions = 2}, middle_of(mesh), kPlaces[0]) / wanted,
              1.0, 0.02);
}

TEST(StiffnessMap, BetweenItsNodesTheMapIsTheNetSolvedDirectly) {
  constexpr std::uint64_t kSeed = 4;
  device::Random random(kSeed);
  const SurfaceMesh mesh = lattice_disc(0.03, 0.005);
  const NetSettings net;
  const StiffnessMap map(mesh, net);
  for (int i = 0; i < 40; ++i) {
    const auto triangle = static_cast<std::uint32_t>(random.bits() % mesh.triangles().size());
    const double u = random.uniform();
    const double v = random.uniform(0.0, 1.0 - u);
    const Vector3d shares(u, v, 1.0 - u - v);
    const double direct = map.spring() / net_compliance(mesh, net, triangle, shares);
    EXPECT_NEAR(map.at(triangle, shares) / direct, 1.0, 0.01) << "seed " << kSeed;
  }
  EXPECT_NEAR(map.at(middle_of(mesh), kPlaces[0]), 1.0, 1e-6);
}

}  // namespace
}  // namespace telepalp::tissue
