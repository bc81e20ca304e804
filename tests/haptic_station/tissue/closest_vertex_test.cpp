#include "haptic_station/tissue/mesh/closest_vertex.h"

#include <gtest/gtest.h>

#include "haptic_station/device/random.h"
#include "tests/haptic_station/tissue/meshes.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

TEST(ClosestVertex, IsThatOfBruteForceOnFlatAndConcaveMeshesAtAnySpeed) {
  constexpr std::uint64_t kSeed = 5;
  device::Random random(kSeed);
  std::uint64_t walks_wrong = 0;
  for (const SurfaceMesh& mesh : {lattice_disc(0.05, 0.004), groove()}) {
    const TriangleTree tree(mesh);
    ClosestVertex closest(mesh, tree);
    std::uint32_t walked = 0;
    Vector3d at_m = Vector3d::Zero();
    for (int i = 0; i < 20'000; ++i) {
      const double hop_m = i % 100 == 0 ? 0.05 : 0.0005;
      at_m += hop_m * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      at_m = at_m.cwiseMax(-0.06).cwiseMin(0.06);
      const std::uint32_t right = brute_force_vertex(mesh, at_m);
      const std::uint32_t found = closest.at(at_m);
      ASSERT_EQ((mesh.vertices()[found] - at_m).norm(), (mesh.vertices()[right] - at_m).norm()) << "seed " << kSeed;
      walked = ClosestVertex::walk(mesh, walked, at_m);
      if ((mesh.vertices()[walked] - at_m).norm() > (mesh.vertices()[right] - at_m).norm()) ++walks_wrong;
    }
    EXPECT_LT(closest.searches(), 15'000u) << "most answers need no search";
  }
  EXPECT_GT(walks_wrong, 1000u) << "the walk of S4 alone fails on the concave mesh";
}

TEST(ClosestVertex, ASweptPointHitsTheFirstTriangleOnItsWayThroughEdgesAndVerticesToo) {
  const SurfaceMesh mesh = lattice_disc(0.05, 0.004);
  const TriangleTree tree(mesh);
  for (std::uint32_t v = 0; v < mesh.vertices().size(); v += 7) {
    const Vector3d& corner = mesh.vertices()[v];
    for (const std::uint32_t other : mesh.ring(v))
      for (const Vector3d& at : {corner, Vector3d(0.5 * (corner + mesh.vertices()[other]))}) {
        const auto hit = tree.first_hit(at + Vector3d(0, 0.03, 0), at - Vector3d(0, 0.03, 0));
        ASSERT_TRUE(hit.has_value());
        EXPECT_LT((hit->at_m - at).norm(), 1e-12);
      }
  }
  EXPECT_FALSE(tree.first_hit({0.2, 0.01, 0.0}, {0.2, -0.01, 0.0}).has_value());
  EXPECT_FALSE(tree.first_hit({0.0, 0.03, 0.0}, {0.0, 0.01, 0.0}).has_value());
}

TEST(ClosestVertex, TheNearestPointIsThatOfAllTriangles) {
  constexpr std::uint64_t kSeed = 9;
  device::Random random(kSeed);
  const SurfaceMesh mesh = groove();
  const TriangleTree tree(mesh);
  for (int i = 0; i < 300; ++i) {
    const Vector3d to_m{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
    double least_m = 1.0;
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)  // no point of a triangle is nearer than tree's answer
      for (int u = 0; u <= 10; ++u)
        for (int v = 0; u + v <= 10; ++v) {
          const Triangle& c = mesh.triangles()[t];
          const Vector3d p =
              (u * mesh.vertices()[c[0]] + v * mesh.vertices()[c[1]] + (10 - u - v) * mesh.vertices()[c[2]]) / 10.0;
          least_m = std::min(least_m, (p - to_m).norm());
        }
    const double found_m = (tree.nearest(to_m).at_m - to_m).norm();
    EXPECT_LE(found_m, least_m + 1e-12) << "seed " << kSeed;
    EXPECT_GE(found_m, least_m - 0.002) << "seed " << kSeed;
  }
}

}  // namespace
}  // namespace telepalp::tissue
