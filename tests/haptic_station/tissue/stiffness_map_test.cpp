#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptic_station/device/random.h"
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

TEST(StiffnessMap, ASubdivisionChangesTheForceByAtMostOnePercent) {
  const TissueSettings usual;
  const SurfaceMesh mesh = lattice_disc(usual.net_radius_m, usual.net_edge_m);
  for (const Vector3d& at : kPlaces) {
    const double whole = net_compliance(mesh, {.subdivisions = 0}, middle_of(mesh), at);
    const double once = net_compliance(mesh, {.subdivisions = 1}, middle_of(mesh), at);
    const double twice = net_compliance(mesh, {.subdivisions = 2}, middle_of(mesh), at);
    EXPECT_NEAR(once / whole, 1.0, 0.01);
    EXPECT_NEAR(twice / once, 1.0, 0.01);
    EXPECT_GT(std::abs(once - whole), std::abs(twice - once)) << "it converges";
  }
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
