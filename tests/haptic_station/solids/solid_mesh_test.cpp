#include "haptic_station/solids/solid_mesh.h"

#include <gtest/gtest.h>

#include <numbers>

#include "haptic_station/solids/polish.h"
#include "tests/haptic_station/solids/random_solid.h"
#include "tests/haptic_station/solids/tree_of.h"

namespace telepalp::solids {
namespace {

using std::numbers::pi;

Result<CheckedMesh> checked(const std::string& text, std::optional<double> smallest_cell_m = {}) {
  return checked_mesh_of(*tree_of(text), {.smallest_cell_m = smallest_cell_m});
}

/// The message of a refusal; empty: not refused.
std::string refusal_of(const std::string& text, std::optional<double> smallest_cell_m = {}) {
  const auto mesh = checked(text, smallest_cell_m);
  return mesh ? "" : to_string(mesh.error());
}

TEST(SolidMesh, IsWatertightForAnyTreeOnAnyCells) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    RandomSolid random(seed);
    const std::string text = random.tree(static_cast<int>(seed % 4));
    const auto tree = tree_of(text);
    const auto mesh = mesh_of(*tree, (tree->box().high - tree->box().low).maxCoeff() / 24.0);
    ASSERT_TRUE(mesh.ok()) << to_string(mesh.error());
    const isosurface::MeshFacts facts = isosurface::facts_of(*mesh);
    EXPECT_EQ(facts.open_edges, 0U) << "seed " << seed << ": " << text;
    EXPECT_GE(facts.volume_m3, 0.0) << "seed " << seed << ": the triangles look inwards";
  }
}

struct Known {
  const char* name;
  const char* polish;
  std::size_t parts;
  long euler;
  double volume_m3;
};
const Known kKnown[] = {
    {"ball", "sphere 0.05", 1, 2, 4.0 / 3.0 * pi * 0.05 * 0.05 * 0.05},
    {"ring", "torusy 0.05 0.02", 1, 0, 2.0 * pi* pi * 0.05 * 0.02 * 0.02},
    {"box", "tx 1 2 3 30 1 2 3 box 0.05 0.03 0.02", 1, 2, 8.0 * 0.05 * 0.03 * 0.02},
    {"plate of 0.8 mm", "box 0.05 0.0004 0.05", 1, 2, 0.1 * 0.1 * 0.0008},
    {"shell of 2 mm", "- sphere 0.05 sphere 0.048", 2, 4, 4.0 / 3.0 * pi*(0.05 * 0.05 * 0.05 - 0.048 * 0.048 * 0.048)},
    {"wire between balls", "+ tr 0.05 0 0 sphere 0.01 + tr -0.05 0 0 sphere 0.01 capsule -0.05 0 0 0.05 0 0 0.0005", 1,
     2, 2.0 * 4.0 / 3.0 * pi * 1e-6 + pi * 0.0005 * 0.0005 * 0.08},
    {"bore holes that meet", "- box 0.04 0.04 0.04 + cylinderx 0.01 0.05 + cylindery 0.01 0.05 cylinderz 0.01 0.05", 1,
     -8, 0.08 * 0.08 * 0.08 - (3.0 * pi * 0.01 * 0.01 * 0.08 - 8.0 * std::numbers::sqrt2 * 0.01 * 0.01 * 0.01)},
    {"pocket flush with a face", "- box 0.05 0.05 0.05 tr 0 0 0.03 box 0.02 0.02 0.02", 1, 2, 1e-3 - 64e-6},
    {"two boxes face to face", "+ box 0.02 0.02 0.02 tr 0.04 0 0 box 0.02 0.02 0.02", 1, 2, 128e-6},
};

TEST(SolidMesh, HasThePartsTheHolesAndTheVolumeOfTheSolid) {
  for (const Known& known : kKnown) {
    const auto made = checked(known.polish);
    ASSERT_TRUE(made.ok()) << known.name << ": " << to_string(made.error());
    EXPECT_EQ(made->facts.open_edges, 0U) << known.name;
    EXPECT_EQ(made->facts.parts, known.parts) << known.name;
    EXPECT_EQ(made->facts.euler, known.euler) << known.name;
    EXPECT_NEAR(made->facts.volume_m3 / known.volume_m3, 1.0, 0.006) << known.name;
    EXPECT_NEAR(made->volume.m3 / known.volume_m3, 1.0, 0.006) << known.name << ", the volume of the solid";
  }
}

TEST(SolidMesh, TwoRingsATenthOfAMillimetreApartStayApart) {
  const std::string rings = "+ tr -0.01 0 0 torusx 0.0184 0.01 tr 0.01 0 0 torusx 0.0186 0.009900";  // gap 0.101 mm
  const auto made = checked(rings);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_EQ(made->facts.parts, 2U);
  EXPECT_EQ(made->facts.euler, 0);
}

TEST(SolidMesh, WhatTheCellsCannotTellApartIsRefusedWithTheCellThatWouldDo) {
  const char* slot = "- box 0.02 0.02 0.02 box 0.0002 0.016 0.03";  // 0.4 mm wide
  const std::string refused = refusal_of(slot, 0.002);
  EXPECT_NE(refused.find("0.4 mm apart"), std::string::npos) << refused;
  double cell_mm = 0.0;
  ASSERT_EQ(std::sscanf(refused.c_str() + refused.find("--cell-mm"), "--cell-mm %lf", &cell_mm), 1) << refused;
  const auto made = checked(slot, 1e-3 * cell_mm);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_EQ(made->facts.euler, 0);
  EXPECT_NEAR(made->facts.volume_m3, 64e-6 - 0.0004 * 0.032 * 0.04, 0.1e-6);
}

TEST(SolidMesh, AThinWallIsRefusedOnCoarseCells) {
  EXPECT_NE(refusal_of("box 0.05 0.0004 0.05", 0.002).find("--cell-mm"), std::string::npos);
  EXPECT_NE(refusal_of("- sphere 0.05 sphere 0.0495", 0.004).find("--cell-mm"), std::string::npos);
}

TEST(SolidMesh, KeepsTheEdgesOfABox) {
  const auto made = checked("tx 0 0 0 20 1 1 0 box 0.03 0.02 0.01");
  ASSERT_TRUE(made.ok());
  EXPECT_NEAR(made->facts.volume_m3, 48e-6, 48e-9) << "a cut edge or corner would lose volume";
  EXPECT_LE(made->facts.slivers, made->mesh.triangles.size() / 500);
}

TEST(SolidMesh, BallsThatTouchAtAPointAreRefused) {
  EXPECT_NE(refusal_of("+ sphere 0.02 tr 0.04 0 0 sphere 0.02"), "");
}

TEST(SolidMesh, ASolidWithoutBoundsOrInsideIsRefused) {
  EXPECT_NE(refusal_of("plane 0 1 0 0").find("without end"), std::string::npos);
  EXPECT_NE(refusal_of("* sphere 0.01 tr 0.5 0 0 sphere 0.01").find("the solid is empty"), std::string::npos);
  EXPECT_FALSE(mesh_of(*tree_of("plane 0 1 0 0"), 0.01).ok());
}

TEST(SolidMesh, WhatNeedsTooManyCellsIsRefused) {
  EXPECT_FALSE(mesh_of(*tree_of("sphere 10"), 1e-4).ok());
  const auto thin = checked_mesh_of(*tree_of("- box 1 1 1 box 0.9999 0.9999 0.9999"), {.most_cells = 20'000});
  ASSERT_FALSE(thin.ok());
  EXPECT_NE(thin.error().what.find("more than 20000 cells"), std::string::npos) << to_string(thin.error());
}

/// Samples that a mesh of a torus takes of its field; `stop` is requested at the sample with number `stop_at`.
struct Sampled {
  std::size_t samples = 0;
  bool made = false;
};
Sampled samples_of_a_torus(std::size_t stop_at) {
  std::stop_source source;
  Sampled sampled;
  const isosurface::Field torus{.at = [&](const Eigen::Vector3d& p) {
    if (++sampled.samples == stop_at) source.request_stop();
    const Eigen::Vector2d ring(p.x(), p.y());
    const Eigen::Vector3d off(p.x() - 0.05 * ring.x() / ring.norm(), p.y() - 0.05 * ring.y() / ring.norm(), p.z());
    return isosurface::FieldAt{off.norm() - 0.02, off.normalized()};
  }};
  const auto made =
      isosurface::extract(torus, {.box = {Eigen::Vector3d(-0.08, -0.08, -0.03), Eigen::Vector3d(0.08, 0.08, 0.03)},
                                  .cell_m = 0.001,
                                  .examine = false,
                                  .stop = source.get_token()});
  sampled.made = made.ok();
  if (!made) {
    EXPECT_EQ(made.error().what, "the extraction was stopped");
  }
  return sampled;
}

TEST(SolidMesh, AStopEndsItAfterTheSamplesOfOneCellWhereverItIs) {
  const Sampled whole = samples_of_a_torus(0);
  ASSERT_TRUE(whole.made);
  ASSERT_GT(whole.samples, 200'000U);
  constexpr std::size_t kOfOneCell = 400;  // twelve edges, each met by up to 26 samples
  for (const double share : {1e-5, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999}) {
    const auto stop_at = 1 + static_cast<std::size_t>(share * static_cast<double>(whole.samples));
    const Sampled stopped = samples_of_a_torus(stop_at);
    EXPECT_FALSE(stopped.made) << share;
    EXPECT_LT(stopped.samples - stop_at, kOfOneCell) << share;
  }
}

TEST(SolidMesh, ProgressOnlyGrowsAndEndsAtOne) {
  double last = 0.0;
  const auto made = checked_mesh_of(*tree_of("torusx 0.05 0.01"), {.progress = [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  }});
  ASSERT_TRUE(made.ok());
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(MeshFacts, CountAHoleTheParts) {
  auto mesh = mesh_of(*tree_of("+ sphere 0.05 tr 0.2 0 0 sphere 0.05"), 0.01);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(isosurface::facts_of(*mesh).parts, 2U);
  EXPECT_EQ(isosurface::facts_of(*mesh).euler, 4);
  mesh->triangles.pop_back();
  EXPECT_EQ(isosurface::facts_of(*mesh).open_edges, 3U);
}

}  // namespace
}  // namespace telepalp::solids
