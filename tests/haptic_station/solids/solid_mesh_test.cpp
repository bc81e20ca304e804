#include "haptic_station/solids/solid_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "haptic_station/solids/polish.h"
#include "tests/haptic_station/solids/random_solid.h"

namespace telepalp::solids {
namespace {

std::shared_ptr<const SolidTree> tree_of(const std::string& text) { return *build_tree(*parse_polish(text, "test")); }

double volume_m3(const SolidMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) sum += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6.0;
  return sum;
}

TEST(SolidMesh, IsWatertightForAnyTree) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    RandomSolid random(seed);
    const std::string text = random.tree(static_cast<int>(seed % 4));
    const auto tree = tree_of(text);
    const auto mesh = mesh_of(*tree, (tree->box().high - tree->box().low).maxCoeff() / 24.0);
    ASSERT_TRUE(mesh.ok()) << to_string(mesh.error());
    EXPECT_EQ(open_edges(*mesh), 0U) << "seed " << seed << ": " << text;
    EXPECT_GE(volume_m3(*mesh), 0.0) << "seed " << seed << ": the triangles look inwards";
  }
}

TEST(SolidMesh, HasTheVolumeOfTheSolid) {
  const auto sphere = mesh_of(*tree_of("sphere 0.05"), 0.002);
  EXPECT_NEAR(volume_m3(*sphere) / (4.0 / 3.0 * 3.14159265 * 0.05 * 0.05 * 0.05), 1.0, 0.003);
  const auto torus = mesh_of(*tree_of("torusy 0.05 0.02"), 0.002);
  EXPECT_NEAR(volume_m3(*torus) / (2.0 * 3.14159265 * 3.14159265 * 0.05 * 0.02 * 0.02), 1.0, 0.003);
}

TEST(SolidMesh, AHoleIsCounted) {
  auto mesh = mesh_of(*tree_of("sphere 0.05"), 0.01);
  ASSERT_TRUE(mesh.ok());
  mesh->triangles.pop_back();
  EXPECT_EQ(open_edges(*mesh), 3U);
}

TEST(SolidMesh, ASolidWithoutBoundsIsRefused) {
  EXPECT_FALSE(mesh_of(*tree_of("plane 0 1 0 0"), 0.01).ok());
  EXPECT_FALSE(mesh_of(*tree_of("sphere 10"), 1e-4).ok());
}

}  // namespace
}  // namespace telepalp::solids
