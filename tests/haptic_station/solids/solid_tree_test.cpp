#include "haptic_station/solids/solid_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptic_station/solids/near_members.h"
#include "haptic_station/solids/polish.h"
#include "tests/haptic_station/solids/random_solid.h"
#include "tests/haptic_station/solids/tree_of.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

/// Central differences, by Richardson's extrapolation.
Vector3d slope(const SolidTree& tree, const Vector3d& p) {
  const auto central = [&](int axis, double h) {
    const Vector3d step = h * Vector3d::Unit(axis);
    return (solid_at(tree, p + step).m - solid_at(tree, p - step).m) / (2.0 * h);
  };
  Vector3d out;
  for (int axis = 0; axis < 3; ++axis) out[axis] = (4.0 * central(axis, 5e-6) - central(axis, 1e-5)) / 3.0;
  return out;
}

/// True when one formula decides all around the point, so that differences are derivatives.
bool away_from_ties(const SolidTree& tree, const Vector3d& p) {
  const SolidAt here = solid_at(tree, p);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-4e-5, 4e-5}) {
      const SolidAt there = solid_at(tree, p + side * Vector3d::Unit(axis));
      if (there.part != here.part || (there.gradient - here.gradient).norm() > 0.02) return false;
    }
  return true;
}

TEST(SolidTree, TheGradientIsTheDerivative) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    RandomSolid random(seed);
    const std::string text = random.tree(static_cast<int>(seed % 5));
    const auto tree = tree_of(text);
    for (int i = 0; i < 30; ++i) {
      const Vector3d p(random.number(-0.1, 0.1), random.number(-0.1, 0.1), random.number(-0.1, 0.1));
      const SolidAt at = solid_at(*tree, p);
      if (!away_from_ties(*tree, p)) continue;
      ++compared;
      ASSERT_LE((slope(*tree, p) - at.gradient).norm(), 1e-6)
          << "seed " << seed << ": " << text << " at " << p.transpose();
    }
  }
  EXPECT_GT(compared, 6000);
}

TEST(SolidTree, ChangesByAtMostTheDistanceMoved) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomSolid random(seed);
    const auto tree = tree_of(random.tree(static_cast<int>(seed % 5)));
    for (int i = 0; i < 100; ++i) {
      const Vector3d a(random.number(-0.2, 0.2), random.number(-0.2, 0.2), random.number(-0.2, 0.2));
      const Vector3d b(random.number(-0.2, 0.2), random.number(-0.2, 0.2), random.number(-0.2, 0.2));
      ASSERT_LE(std::abs(solid_at(*tree, a).m - solid_at(*tree, b).m), (a - b).norm() * (1.0 + 1e-9) + 1e-15)
          << "seed " << seed;
    }
  }
}

TEST(SolidTree, IsNotLowerThanTheDistanceToItsBox) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomSolid random(seed);
    const auto tree = tree_of(random.tree(static_cast<int>(seed % 5)));
    for (int i = 0; i < 100; ++i) {
      const Vector3d p(random.number(-0.5, 0.5), random.number(-0.5, 0.5), random.number(-0.5, 0.5));
      const double box_m = std::sqrt(tree->box().squared_distance_m2(p));
      if (box_m <= 0.0) continue;
      ASSERT_GE(solid_at(*tree, p).m + 1e-12, box_m) << "seed " << seed;
    }
  }
}

TEST(SolidTree, AUnionIsTheLeastOfItsMembersWhateverIsSkipped) {
  RandomSolid random(7);
  std::string chain;
  std::vector<std::shared_ptr<const SolidTree>> members;
  constexpr int kMembers = 200;
  for (int i = 0; i < kMembers; ++i) {
    const std::string one = "tr" + random.three(0.5) + " " + random.tree(i % 3);
    chain += (i + 1 < kMembers ? "+ " : "") + one + " ";
    members.push_back(tree_of(one));
  }
  const auto joined = tree_of(chain);
  EXPECT_GE(joined->shapes, std::size_t{kMembers});
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p(random.number(-0.6, 0.6), random.number(-0.6, 0.6), random.number(-0.6, 0.6));
    double least = HUGE_VAL;
    for (const auto& member : members) least = std::min(least, solid_at(*member, p).m);
    ASSERT_NEAR(solid_at(*joined, p).m, least, 1e-15);
  }
}

TEST(NearMembers, GiveTheValueOfTheWholeTreeOnAnyPath) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomSolid random(seed);
    std::string text = seed % 2 == 0 ? "tx 0.01 0 0.02 30 0 1 1 sc 1.5 " : "";
    const int members = 2 + static_cast<int>(seed % 30);
    for (int i = 0; i + 1 < members; ++i) text += "+ " + random.tree(static_cast<int>(seed % 3)) + " ";
    const auto tree = tree_of(text + random.tree(0));
    NearMembers near;
    Vector3d p(random.number(-0.1, 0.1), random.number(-0.1, 0.1), random.number(-0.1, 0.1));
    for (int i = 0; i < 400; ++i) {
      const double reach_m = i % 100 == 99 ? 0.1 : 0.0008;  // a slow hand, and now and then a jump
      p += Vector3d(random.number(-reach_m, reach_m), random.number(-reach_m, reach_m),
                    random.number(-reach_m, reach_m));
      const SolidAt whole = solid_at(*tree, p);
      const SolidAt few = near.at(*tree, p);
      ASSERT_EQ(few.m, whole.m) << "seed " << seed << ": " << text << " at " << p.transpose();
      ASSERT_EQ(few.part, whole.part);
      ASSERT_LE((few.gradient - whole.gradient).norm(), 1e-12);
    }
  }
}

TEST(SolidTree, ShapesGiveTheDistanceWhereTheTypeSaysSo) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomSolid random(seed);
    const std::string text = random.shape();
    const auto tree = tree_of(text);
    if (tree->exactness() == Exactness::Bound) continue;
    for (int i = 0; i < 50; ++i) {
      const Vector3d p(random.number(-0.15, 0.15), random.number(-0.15, 0.15), random.number(-0.15, 0.15));
      const SolidAt at = solid_at(*tree, p);
      if (at.m < 0.0 && tree->exactness() == Exactness::Outside) continue;
      ASSERT_NEAR(at.gradient.norm(), 1.0, 1e-9) << text;
      const Vector3d foot = p - at.m * at.gradient;
      ASSERT_NEAR(solid_at(*tree, foot).m, 0.0, 1e-9) << text << " from " << p.transpose();
    }
  }
}

TEST(SolidTree, APointThatIsNotFiniteIsFarOutside) {
  const auto tree = tree_of("+ sphere 0.1 box 1 1 1");
  EXPECT_TRUE(std::isinf(solid_at(*tree, Vector3d(std::nan(""), 0.0, 0.0)).m));
  EXPECT_TRUE(std::isinf(solid_at(*tree, Vector3d(0.0, HUGE_VAL, 0.0)).m));
}

TEST(SolidTree, AHierarchyIsAsDeepAsTheLogarithmOfItsMembers) {
  std::string chain;
  constexpr int kMembers = 10'000;
  for (int i = 0; i < kMembers; ++i)
    chain += std::string(i + 1 < kMembers ? "+ " : "") + "tr " + std::to_string(i % 100) + " " +
             std::to_string(i / 100) + " 0 sphere 0.2 ";
  const auto tree = tree_of(chain);
  const auto deepest = [&](auto&& self, std::uint32_t node) -> int {
    int below = 0;
    for (const std::uint32_t child : tree->boxes[node].child)
      if (child != kNothing && (child & BoxNode::kMember) == 0) below = std::max(below, self(self, child));
    return 1 + below;
  };
  EXPECT_LE(deepest(deepest, tree->nodes[tree->root].hierarchy), 7) << "log4 of 10000 is 6.6";
  EXPECT_NEAR(solid_at(*tree, {50.0, 50.3, 0.0}).m, 0.1, 1e-12);
}

}  // namespace
}  // namespace telepalp::solids
