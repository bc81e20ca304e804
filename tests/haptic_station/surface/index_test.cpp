#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "haptic_station/surface/paper/paper_surface.h"
#include "haptic_station/surface/pcl_search/pcl_indexes.h"
#include "haptic_station/surface/touch/touch.h"
#include "tests/haptic_station/surface/analytic_surface.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

IndexedPoints random_points(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> side(-0.1F, 0.1F);
  IndexedPoints points;
  for (int i = 0; i < count; ++i) points.at_m.emplace_back(side(random), side(random), 0.8F + 0.2F * side(random));
  points.at_m[3].setConstant(std::numeric_limits<float>::quiet_NaN());
  return points;
}

std::vector<float> nearest_by_hand(const IndexedPoints& points, const Vector3f& query, float radius, std::size_t most) {
  std::vector<float> squared;
  for (const Vector3f& at : points.at_m)
    if (at.allFinite() && (at - query).squaredNorm() < radius * radius) squared.push_back((at - query).squaredNorm());
  std::sort(squared.begin(), squared.end());
  if (squared.size() > most) squared.resize(most);
  return squared;
}

class EveryIndex : public ::testing::TestWithParam<Index> {
 protected:
  void SetUp() override { use_pcl_indexes(); }
  void TearDown() override { set_pcl_indexes({}); }
};

TEST_P(EveryIndex, FindsWhatASearchByHandFinds) {
  const IndexedPoints points = random_points(11, 3000);
  const auto index = make_index(GetParam(), points);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> side(-0.12F, 0.12F);
  for (int i = 0; i < 200; ++i) {
    const Vector3f query(side(random), side(random), 0.8F + 0.3F * side(random));
    std::vector<Neighbor> found(i % 2 == 0 ? 10 : 200);
    found.resize(index->within(query, 0.03F, found));
    std::vector<float> squared;
    for (const Neighbor& neighbor : found) squared.push_back((points.at_m[neighbor.index] - query).squaredNorm());
    std::sort(squared.begin(), squared.end());
    const std::vector<float> expected = nearest_by_hand(points, query, 0.03F, i % 2 == 0 ? 10 : 200);
    ASSERT_EQ(squared.size(), expected.size()) << index->name() << " query " << i;
    for (std::size_t k = 0; k < squared.size(); ++k) EXPECT_NEAR(squared[k], expected[k], 1e-9F);
  }
}

TEST_P(EveryIndex, OverADepthImageFindsTheNearestToo) {
  const auto surface = testing::sphere({0, 0, 0.88}, 0.08);
  const Intrinsics camera = testing::camera_with_spacing(0.8, 0.004);
  const auto image = testing::render(*surface, camera, {.sigma_m = 0.001});
  const IndexedPoints points = to_points(to_depth_field(image), camera);
  const auto index = make_index(GetParam(), points);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<float> side(-0.03F, 0.03F);
  for (int i = 0; i < 50; ++i) {
    const Vector3f query(side(random), side(random), 0.81F + 0.3F * side(random));
    std::vector<Neighbor> found(10);
    found.resize(index->within(query, 0.1F, found));
    std::vector<float> squared;
    for (const Neighbor& neighbor : found) squared.push_back(neighbor.squared_m2);
    std::sort(squared.begin(), squared.end());
    const std::vector<float> expected = nearest_by_hand(points, query, 0.1F, 10);
    ASSERT_EQ(squared.size(), expected.size()) << index->name() << " query " << i;
    for (std::size_t k = 0; k < squared.size(); ++k) EXPECT_NEAR(squared[k], expected[k], 1e-9F);
  }
}

TEST_P(EveryIndex, OverNoPointsFindsNone) {
  const auto index =
      make_index(GetParam(), {.at_m = {Vector3f::Constant(std::numeric_limits<float>::quiet_NaN())}, .width = 0});
  std::vector<Neighbor> found(4);
  EXPECT_EQ(index->within({0, 0, 1}, 10.0F, found), 0U);
}

INSTANTIATE_TEST_SUITE_P(All, EveryIndex, ::testing::Values(Index::PclKdTree, Index::Nanoflann, Index::PclOrganized));

TEST(WithoutPcl, AnIndexOfPclIsMadeByNanoflann) {
  for (const Index kind : {Index::PclKdTree, Index::PclOrganized})
    EXPECT_STREQ(make_index(kind, random_points(3, 100))->name(), "nanoflann KD-tree");
}

TEST_P(EveryIndex, HasTheNameOfItsLibrary) {
  const bool is_ours = GetParam() == Index::Nanoflann;
  EXPECT_EQ(std::string(make_index(GetParam(), random_points(3, 100))->name()).starts_with("PCL"), !is_ours);
}

TEST(PaperSurface, OnAPlaneFIsTheDistance) {
  const auto surface = testing::plane({0, 0, 0.8}, {0.1, 0.2, -1.0});
  const Intrinsics camera = testing::camera_with_spacing(0.8, 0.004);
  const auto image = testing::render(*surface, camera, {});
  for (const char* name : {"paper", "paper-nanoflann", "paper-organized"}) {
    const auto snapshot = build_snapshot(image, camera, session_time(1), std::nullopt, *surface_settings(name));
    ASSERT_NE(snapshot, nullptr) << name;
    const FieldSample sample = snapshot->evaluate({0.01, 0.02, 0.79}, Vector3d::Zero(), {});
    ASSERT_TRUE(sample.valid) << name;
    EXPECT_NEAR(sample.f_m, surface->foot({0.01, 0.02, 0.79}).distance_m, 2e-5) << name;
    EXPECT_LT(sample.normal.cross(surface->foot({0, 0, 0}).normal).norm(), 0.01) << name;
    EXPECT_FALSE(snapshot->realtime_safe());
  }
}

TEST(CloudSurface, TheGradientIsThatOfFForAFixedSupport) {
  const auto surface = testing::sphere({0, 0, 0.88}, 0.08);
  const Intrinsics camera = testing::camera_with_spacing(0.8, 0.0015);
  const auto snapshot = build_snapshot(testing::render(*surface, camera, {}), camera, session_time(1),
                                       Reach{{{0, 0, 0.8}}, 0.04}, *surface_settings("cloud"));
  ASSERT_NE(snapshot, nullptr);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> side(-0.02, 0.02);
  for (int i = 0; i < 40; ++i) {
    const Vector3d at = surface->foot({side(random), side(random), 0.8}).at * (1.0 + 0.1 * side(random));
    const FieldSample here = snapshot->evaluate(at, Vector3d::Zero(), {});
    ASSERT_TRUE(here.valid);
    EXPECT_NEAR(here.f_m, surface->foot(at).distance_m, 2e-5);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = 2e-5 * Vector3d::Unit(axis);
      const double slope = (snapshot->evaluate(at + step, Vector3d::Zero(), {}).f_m -
                            snapshot->evaluate(at - step, Vector3d::Zero(), {}).f_m) /
                           4e-5;
      EXPECT_NEAR(slope, here.gradient[axis], 3e-3);
    }
  }
}

}  // namespace
}  // namespace telepalp::surface
