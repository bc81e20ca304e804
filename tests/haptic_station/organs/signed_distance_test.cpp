#include "haptic_station/organs/signed_distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace telepalp::organs {
namespace {

using Eigen::Vector3d;
using models::PointModel;

/// The unit cube of 0.1 m, with its faces looking outwards.
PointModel cube() {
  PointModel model;
  for (int i = 0; i < 8; ++i)
    model.points.emplace_back(0.1F * static_cast<float>(i & 1), 0.1F * static_cast<float>(i >> 1 & 1),
                              0.1F * static_cast<float>(i >> 2));
  model.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return model;
}

double true_distance_m(const Vector3d& p) {
  const Vector3d q = (p - Vector3d::Constant(0.05)).cwiseAbs() - Vector3d::Constant(0.05);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

void expect_cube(const solids::DistanceLattice& lattice) {
  for (int k = 0; k < lattice.size[2]; ++k)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i) {
        const Vector3d at = lattice.origin_m + lattice.spacing_m * Vector3d(i, j, k);
        ASSERT_NEAR(lattice.nodes_m[lattice.index(i, j, k)], true_distance_m(at), 1e-7) << at.transpose();
      }
}

std::string complaint(const PointModel& model, double spacing_m = 0.01) {
  const auto made = signed_distance(model, spacing_m, 0.02);
  return made.ok() ? "" : to_string(made.error());
}

TEST(SignedDistance, IsExactAtEveryNodeAroundACubeWithItsEdgesAndCorners) {
  const auto lattice = signed_distance(cube(), 0.007, 0.03);
  ASSERT_TRUE(lattice.ok()) << to_string(lattice.error());
  expect_cube(*lattice);
}

TEST(SignedDistance, AMeshTurnedInsideOutIsTurnedBack) {
  PointModel model = cube();
  for (auto& t : model.triangles) std::swap(t[1], t[2]);
  const auto lattice = signed_distance(model, 0.01, 0.02);
  ASSERT_TRUE(lattice.ok());
  expect_cube(*lattice);
}

TEST(SignedDistance, VerticesInOnePlaceCountAsOne) {
  const PointModel shared = cube();
  PointModel soup;
  for (const auto& t : shared.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : t) soup.points.push_back(shared.points[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const auto lattice = signed_distance(soup, 0.01, 0.02);
  ASSERT_TRUE(lattice.ok()) << to_string(lattice.error());
  expect_cube(*lattice);
}

TEST(SignedDistance, AFaceWithoutAreaChangesNothing) {
  PointModel model = cube();
  model.triangles.push_back({0, 0, 1});
  const auto lattice = signed_distance(model, 0.01, 0.02);
  ASSERT_TRUE(lattice.ok()) << to_string(lattice.error());
  expect_cube(*lattice);
}

TEST(SignedDistance, AnOpenMeshIsRefusedWithTheNumberOfItsEdges) {
  PointModel model = cube();
  model.triangles.pop_back();
  EXPECT_NE(complaint(model).find("not closed: 3 edges"), std::string::npos) << complaint(model);
}

TEST(SignedDistance, OneFaceTurnedTheWrongWayIsRefused) {
  PointModel model = cube();
  std::swap(model.triangles[4][1], model.triangles[4][2]);
  EXPECT_NE(complaint(model).find("not closed"), std::string::npos) << complaint(model);
}

TEST(SignedDistance, WhatHasNoFacesOrNoVolumeOrNoNumbersIsRefused) {
  EXPECT_NE(complaint({}).find("no faces"), std::string::npos);
  PointModel cloud = cube();
  cloud.triangles.clear();
  EXPECT_NE(complaint(cloud).find("no faces"), std::string::npos);
  PointModel flat = cube();
  for (auto& p : flat.points) p.y() = 0.0F;
  EXPECT_NE(complaint(flat), "");
  PointModel broken = cube();
  broken.points[3].x() = std::nanf("");
  EXPECT_NE(complaint(broken).find("not finite"), std::string::npos) << complaint(broken);
}

TEST(SignedDistance, AMeshInMillimetresTakenForMetresIsRefusedBeforeAnythingIsAllocated) {
  PointModel model = cube();
  for (auto& p : model.points) p *= 1000.0F;
  EXPECT_NE(complaint(model).find("check the unit"), std::string::npos) << complaint(model);
}

}  // namespace
}  // namespace telepalp::organs
