#include "haptic_station/surface/cloud/static_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>

#include "haptic_station/surface/cloud/cloud_noise.h"
#include "haptic_station/surface/cloud/winding_number.h"
#include "haptic_station/surface/touch/touch.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// A ball of triangles around `middle`; `with_normals`: exact ones at its vertices.
models::PointModel ball(double radius_m, const Vector3d& middle, bool with_normals, int rings = 40) {
  models::PointModel mesh;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < 2 * rings; ++i) {
      const double polar = M_PI * j / rings;
      const double around = M_PI * i / rings;
      const double ring = j == 0 || j == rings ? 0.0 : std::sin(polar);  // a pole's vertices coincide
      const Vector3d n(ring * std::cos(around), ring * std::sin(around), std::cos(polar));
      mesh.points.push_back((middle + radius_m * n).cast<float>());
      if (with_normals) mesh.normals.push_back(n.cast<float>());
    }
  const auto at = [&](int j, int i) { return static_cast<std::uint32_t>(j * 2 * rings + i % (2 * rings)); };
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < 2 * rings; ++i) {
      if (j > 0) mesh.triangles.push_back({at(j, i), at(j + 1, i), at(j, i + 1)});
      if (j + 1 < rings) mesh.triangles.push_back({at(j, i + 1), at(j + 1, i), at(j + 1, i + 1)});
    }
  return mesh;
}

double nearest_m(const std::vector<CloudPoint>& points, std::size_t of) {
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i != of) least = std::min(least, (points[i].at_m - points[of].at_m).squaredNorm());
  return std::sqrt(static_cast<double>(least));
}

TEST(PoissonDisk, GivesTheCountAskedForSpreadEvenlyOverTheArea) {
  const models::PointModel mesh = ball(0.1, {0, 0, 1}, true);
  constexpr std::size_t kCount = 2000;
  const std::vector<CloudPoint> points = poisson_disk_samples(mesh, kCount, 7);
  ASSERT_EQ(points.size(), kCount);
  // Hexagonal packing of as many discs would keep its points this far apart: blue noise reaches two thirds of it.
  const double best_m = std::sqrt(2.0 / std::sqrt(3.0) * 4.0 * M_PI * 0.01 / kCount);
  double least_m = 1.0;
  int upper = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    least_m = std::min(least_m, nearest_m(points, i));
    upper += points[i].at_m.z() > 1.0F ? 1 : 0;
  }
  EXPECT_GT(least_m, 0.55 * best_m) << "a uniform draw comes to about 0.01";
  EXPECT_NEAR(upper, 1000, 25);
}

TEST(PoissonDisk, TheSameSeedGivesTheSamePoints) {
  const models::PointModel mesh = ball(0.1, {0, 0, 1}, false, 12);
  const auto first = poisson_disk_samples(mesh, 500, 3);
  const auto again = poisson_disk_samples(mesh, 500, 3);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].at_m, again[i].at_m);
}

TEST(PoissonDisk, KeepsTheNormalsThatTheMeshGave) {
  for (const CloudPoint& point : poisson_disk_samples(ball(0.1, {0, 0, 1}, true), 1000, 1)) {
    const Vector3f outwards = (point.at_m - Vector3f(0, 0, 1)).normalized();
    ASSERT_GT(outwards.dot(point.normal), 0.9999F);
  }
}

TEST(StaticModel, ABallIsTouchedWhereItIsFromEverySideHoweverFarAway) {
  for (const Vector3d& middle : {Vector3d(0, 0, 1), Vector3d(2000, -1000, 500)}) {
    const auto model = make_static_model(ball(0.1, middle, true), {});
    ASSERT_TRUE(model.ok());
    EXPECT_EQ(model->remarks, "");
    for (const Vector3d& side : {Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0.6, 0, 0.8), Vector3d(0, 0, -1)}) {
      Touch touch;
      touch.adopt(*model->snapshot, SessionTime{});
      TouchSample felt;
      for (int i = 0; i <= 300; ++i) felt = touch.step({middle + (0.12 - 0.0001 * i) * side}, SessionTime{}, 0.0005);
      ASSERT_TRUE(felt.in_body) << side.transpose();
      const double tolerance_m = middle.norm() > 100.0 ? 5e-4 : 2.5e-4;  // floats; triangles
      EXPECT_NEAR((felt.proxy.m - middle).norm(), 0.1, tolerance_m) << side.transpose();
      EXPECT_GT(felt.normal.dot(side), 0.999) << side.transpose();
    }
  }
}

/// Distance of the proxy from `middle` when a hand has pressed 10 mm into a ball of 0.1 m from above.
double felt_radius_m(const SurfaceSnapshot& snapshot, const Vector3d& middle) {
  Touch touch;
  touch.adopt(snapshot, SessionTime{});
  TouchSample felt;
  for (int i = 0; i <= 300; ++i)
    felt = touch.step({middle + (0.12 - 0.0001 * i) * Vector3d::UnitX()}, SessionTime{}, 0.0005);
  return felt.in_body ? (felt.proxy.m - middle).norm() : 0.0;
}

TEST(StaticModel, AClosedMeshWithRandomlyOrientedFacesIsRepaired) {
  models::PointModel mesh = ball(0.1, {0, 0, 1}, false);
  std::mt19937 random(3);
  for (auto& triangle : mesh.triangles)
    if (random() % 2 == 0) std::swap(triangle[1], triangle[2]);
  const auto model = make_static_model(mesh, {});
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  EXPECT_NE(model->remarks.find("were oriented against their neighbours"), std::string::npos) << model->remarks;
  EXPECT_EQ(model->remarks.find("open"), std::string::npos) << model->remarks;
  EXPECT_NEAR(felt_radius_m(*model->snapshot, {0, 0, 1}), 0.1, 5e-4);
}

TEST(StaticModel, AMeshWhoseNormalsAreRandomIsTouchedByItsFaces) {
  models::PointModel mesh = ball(0.1, {0, 0, 1}, true);
  std::mt19937 random(3);
  for (Vector3f& normal : mesh.normals)
    if (random() % 2 == 0) normal = -normal;
  const auto model = make_static_model(mesh, {});
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  EXPECT_NE(model->remarks.find("normals contradict its faces"), std::string::npos) << model->remarks;
  EXPECT_NEAR(felt_radius_m(*model->snapshot, {0, 0, 1}), 0.1, 5e-4);
}

/// A ball of 0.3 m, and beside it five of 8 mm: a body's fingers.
models::PointModel body_with_fingers() {
  models::PointModel body = ball(0.3, {0, 0, 1}, false, 60);
  for (int finger = 0; finger < 5; ++finger) {
    const auto first = static_cast<std::uint32_t>(body.points.size());
    const models::PointModel tip = ball(0.008, {0.35, 0.03 * finger, 1}, false, 16);
    body.points.insert(body.points.end(), tip.points.begin(), tip.points.end());
    for (const auto& at : tip.triangles) body.triangles.push_back({first + at[0], first + at[1], first + at[2]});
  }
  return body;
}

TEST(StaticModel, SamplesTooCoarseForTheShapeAreRefusedUnlessAcceptedAndTheCostIsSaid) {
  const auto refused = make_static_model(body_with_fingers(), {.spacing_m = 0.04});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("points 40.0 mm apart"), std::string::npos) << to_string(refused.error());
  EXPECT_NE(refused.error().fix.find("--anyway"), std::string::npos);
  const auto accepted = make_static_model(body_with_fingers(), {.spacing_m = 0.04, .anyway = true});
  ASSERT_TRUE(accepted.ok());
  EXPECT_NE(accepted->sampling.find("40.0 mm apart"), std::string::npos) << accepted->sampling;
}

TEST(StaticModel, SamplesFollowFromTheShapeSoThatNothingIsFeltInTheAirBesideAFinger) {
  const auto model = make_static_model(body_with_fingers(), {});
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  EXPECT_EQ(model->sampling.find("free air"), std::string::npos) << model->sampling;
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (int i = 0; i < 500; ++i) {
    const Vector3d way = Vector3d(any(random), any(random), any(random)).normalized();
    const Vector3d at = Vector3d(0.35, 0.03 * (i % 5), 1) + (0.011 + 0.003 * (i % 2)) * way;
    TouchSettings settings;
    settings.gentle_start = false;
    Touch touch(settings);
    touch.adopt(*model->snapshot, SessionTime{});
    const TouchSample sample = touch.step({at}, SessionTime{}, 0.0005);
    EXPECT_FALSE(sample.valid && sample.in_body) << i << ": " << at.transpose();
  }
}

TEST(StaticModel, APartInsideAnotherIsNotTouchedEvenWhenTheMeshIsOpen) {
  models::PointModel body = ball(0.1, {0, 0, 1}, false);
  body.triangles.resize(body.triangles.size() - 80);  // the ring at the pole away from the hand is gone: open
  const models::PointModel within = ball(0.095, {0, 0, 1}, false);
  const auto first = static_cast<std::uint32_t>(body.points.size());
  body.points.insert(body.points.end(), within.points.begin(), within.points.end());
  for (const auto& at : within.triangles) body.triangles.push_back({first + at[0], first + at[1], first + at[2]});
  const auto model = make_static_model(body, {});
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  EXPECT_NE(model->remarks.find("open"), std::string::npos) << model->remarks;
  EXPECT_NE(model->sampling.find("47 % of the mesh lies inside other parts"), std::string::npos) << model->sampling;
  EXPECT_NEAR(felt_radius_m(*model->snapshot, {0, 0, 1}), 0.1, 5e-4);
}

/// A slab of 60 mm x 60 mm around `middle`, closed, with faces outwards.
models::PointModel slab(double thick_m, const Vector3d& middle) {
  models::PointModel mesh;
  for (const double z : {-0.5 * thick_m, 0.5 * thick_m})
    for (const double y : {-0.03, 0.03})
      for (const double x : {-0.03, 0.03}) mesh.points.push_back((middle + Vector3d(x, y, z)).cast<float>());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(ThinWalls, AreSaidWithTheirShareThicknessAndPlace) {
  const auto thin = make_static_model(slab(0.0032, {0.5, 0, 0}), {.spacing_m = 0.002, .anyway = true});
  ASSERT_TRUE(thin.ok()) << to_string(thin.error());
  const std::string& said = thin->sampling;
  const std::size_t at = said.find(" % of the surface has walls thinner than two spacings");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_GT(std::stod(said.substr(said.rfind(' ', at - 1))), 85.0) << said;  // both sides, not the rim
  EXPECT_NE(said.find("under 3.5 mm at (0.", at), std::string::npos) << said;
  const auto thick = make_static_model(slab(0.0032, {0.5, 0, 0}), {.spacing_m = 0.001, .anyway = true});
  ASSERT_TRUE(thick.ok()) << to_string(thick.error());
  EXPECT_EQ(thick->sampling.find("thinner than two spacings"), std::string::npos) << thick->sampling;
}

TEST(ThinWalls, AnOpenSheetHasNone) {
  models::PointModel sheet = slab(0.003, {0, 0, 0});
  sheet.triangles = {{4, 5, 6}, {5, 7, 6}};
  const auto made = make_static_model(sheet, {.spacing_m = 0.002, .anyway = true});
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_EQ(made->sampling.find("thinner than two spacings"), std::string::npos) << made->sampling;
}

TEST(WindingNumber, IsOneInsideZeroOutsideAndTwoWhereBodiesOverlap) {
  models::PointModel two = ball(0.1, {0, 0, 1}, false);
  const models::PointModel other = ball(0.1, {0.1, 0, 1}, false);
  const auto first = static_cast<std::uint32_t>(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (const auto& at : other.triangles) two.triangles.push_back({first + at[0], first + at[1], first + at[2]});
  const WindingNumber winding(two);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-0.25, 0.25);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d at = Vector3d(any(random), any(random), 1.0 + any(random));
    const double to_first = (at - Vector3d(0, 0, 1)).norm();
    const double to_other = (at - Vector3d(0.1, 0, 1)).norm();
    if (std::abs(to_first - 0.1) < 0.001 || std::abs(to_other - 0.1) < 0.001) continue;  // between ball and facets
    EXPECT_NEAR(winding.at(at), (to_first < 0.1 ? 1.0 : 0.0) + (to_other < 0.1 ? 1.0 : 0.0), 0.03) << at.transpose();
  }
}

TEST(WindingNumber, OfACloudNeedsNoTriangles) {
  const std::vector<CloudPoint> points = poisson_disk_samples(ball(0.1, {0, 0, 1}, true), 3000, 5);
  const WindingNumber winding(points, std::vector<double>(3000, 4.0 * M_PI * 0.01 / 3000.0));
  for (int i = 0; i < 50; ++i) {
    const Vector3d way = points[60 * static_cast<std::size_t>(i)].normal.cast<double>();
    EXPECT_NEAR(winding.at(Vector3d(0, 0, 1) + 0.09 * way), 1.0, 0.1);
    EXPECT_NEAR(winding.at(Vector3d(0, 0, 1) + 0.11 * way), 0.0, 0.1);
  }
}

TEST(StaticModel, ACloudKeepsItsPointsAndItsGivenNormals) {
  models::PointModel cloud;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 40; ++i) {
      cloud.points.emplace_back(0.002F * static_cast<float>(i), 0.002F * static_cast<float>(j), 0.5F);
      cloud.normals.emplace_back(0.0F, 0.0F, 3.0F);  // points away from the origin; its length is not 1
    }
  cloud.normals[7].setConstant(std::numeric_limits<float>::quiet_NaN());
  cloud.normals[9].setZero();
  const auto model = make_static_model(cloud, {});
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->snapshot->points, 1598U) << "two have no normal";
  const FieldSample above = model->snapshot->evaluate({0.04, 0.04, 0.503}, Vector3d::Zero(), {});
  EXPECT_NEAR(above.f_m, 0.003, 1e-6);
  EXPECT_GT(above.normal.z(), 0.999);
}

/// 120 × 120 points on a hill of 40 mm, with noise along each axis.
IndexedPoints noisy_hill(float noise_m, float spacing_m = 0.002F) {
  IndexedPoints hill;
  std::mt19937 random(9);
  std::normal_distribution<float> noise(0.0F, noise_m);
  for (int j = -60; j < 60; ++j)
    for (int i = -60; i < 60; ++i) {
      const float x = spacing_m * static_cast<float>(i);
      const float y = spacing_m * static_cast<float>(j);
      const float z = 0.8F - 0.04F * std::exp(-(x * x + y * y) / (2.0F * 0.05F * 0.05F));
      hill.at_m.emplace_back(x + noise(random), y + noise(random), z + noise(random));
    }
  return hill;
}

TEST(CloudNoise, IsMeasuredToATenthAndTheSupportFollowsIt) {
  for (const float noise_m : {0.0F, 0.0005F, 0.001F, 0.002F, 0.004F}) {
    const IndexedPoints hill = noisy_hill(noise_m);
    const CloudNoise noise = noise_of(hill, *make_nanoflann_index(hill), 0.002);
    EXPECT_TRUE(noise.is_surface);
    EXPECT_NEAR(noise.noise_m, noise_m, 0.1 * static_cast<double>(noise_m) + 2e-5);
    EXPECT_GE(noise.support_m, std::max(0.006, 4.0 * noise.noise_m));
    EXPECT_EQ(noise.follows_noise(), noise_m > 0.0004F) << noise_m;
  }
}

TEST(CloudNoise, ACloudThatIsThinnedSaysHowManyPointsAreKept) {
  models::PointModel cloud;
  cloud.points = noisy_hill(0.004F, 0.0005F).at_m;
  const auto made = make_static_model(cloud, {.anyway = true});
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_LT(made->snapshot->points, 10'000U);
  EXPECT_TRUE(made->sampling.starts_with("14400 points")) << made->sampling;
  EXPECT_NE(
      made->sampling.find("; " + std::to_string(made->snapshot->points) + " of the points, chosen at random, are kept"),
      std::string::npos)
      << made->sampling;
  cloud.points = noisy_hill(0.0F).at_m;
  const auto whole = make_static_model(cloud, {});
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  EXPECT_EQ(whole->sampling.find("are kept"), std::string::npos) << whole->sampling;
}

TEST(CloudNoise, OfPointsThatFillAVolumeSaysThatTheyAreNoSurface) {
  IndexedPoints heap;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> any(-0.1F, 0.1F);
  for (int i = 0; i < 8000; ++i) heap.at_m.emplace_back(any(random), any(random), any(random));
  models::PointModel cloud;
  cloud.points = heap.at_m;
  const auto made = make_static_model(cloud, {});
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().fix.find("--anyway"), std::string::npos) << to_string(made.error());
  EXPECT_TRUE(make_static_model(cloud, {.anyway = true}).ok());
}

/// The points and normals of a dome: the upper half of a ball, open below.
models::PointModel dome() {
  models::PointModel cloud;
  for (const CloudPoint& point : poisson_disk_samples(ball(0.1, {0, 0, 1}, true), 4000, 3))
    if (point.normal.z() > 0.0F) {
      cloud.points.push_back(point.at_m);
      cloud.normals.push_back(point.normal);
    }
  return cloud;
}

TEST(CloudOrientation, AFewReversedNormalsOfAnOpenCloudAreReversedBack) {
  models::PointModel cloud = dome();
  for (std::size_t i = 0; i < cloud.normals.size(); i += 20) cloud.normals[i] = -cloud.normals[i];
  const auto made = make_static_model(cloud, {.viewpoint_m = {0, 0, 3}});
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_NE(made->remarks.find("5.0 % of the normals contradicted"), std::string::npos) << made->remarks;
  for (const CloudPoint& point : made->snapshot->cloud()) ASSERT_GT(point.normal.z(), 0.0F);
}

/// A floor with a fin upright on it, 60 mm long and 30 mm high, whose two walls meet at twice `half_angle_deg`. All
/// normals point outwards.
models::PointModel fin_on_floor(double half_angle_deg) {
  const double half = half_angle_deg * M_PI / 180.0;
  models::PointModel cloud;
  const auto add = [&](const Vector3d& at, const Vector3d& normal) {
    cloud.points.push_back(at.cast<float>());
    cloud.normals.push_back(normal.cast<float>());
  };
  for (int i = -40; i <= 40; ++i)
    for (int j = -40; j <= 40; ++j) {
      const double y = 0.002 * j;
      const bool below_fin = std::abs(i) <= 15 && std::abs(y) < 0.03 * std::tan(half);
      if (!below_fin) add({0.002 * i, y, 0.0}, Vector3d::UnitZ());
    }
  for (int i = -15; i <= 15; ++i)
    for (double down_m = 0.001; down_m < 0.03; down_m += 0.002)
      for (const double side : {-1.0, 1.0})
        add({0.002 * i, side * down_m * std::tan(half), 0.03 - down_m}, {0.0, side * std::cos(half), std::sin(half)});
  return cloud;
}

TEST(CloudOrientation, NormalsOfTheFileAreKeptOnBothWallsOfAThinFin) {
  for (const double half_angle_deg : {5.0, 8.0, 12.0}) {
    const models::PointModel cloud = fin_on_floor(half_angle_deg);
    const auto made = make_static_model(cloud, {.anyway = true, .viewpoint_m = {0, 0, 3}});
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    const std::vector<CloudPoint>& kept = made->snapshot->cloud();
    ASSERT_EQ(kept.size(), cloud.normals.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      ASSERT_GT(kept[i].normal.dot(cloud.normals[i]), 0.9F) << half_angle_deg << ": " << made->remarks;
    EXPECT_EQ(made->remarks, "") << half_angle_deg;
  }
}

TEST(CloudOrientation, AReversedPatchOfASmoothCloudIsReversedBack) {
  models::PointModel cloud = dome();
  for (std::size_t i = 0; i < cloud.normals.size(); ++i)
    if ((cloud.points[i] - cloud.points[cloud.points.size() / 3]).norm() < 0.02F) cloud.normals[i] = -cloud.normals[i];
  const auto made = make_static_model(cloud, {.viewpoint_m = {0, 0, 3}});
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_NE(made->remarks.find("of the normals contradicted their neighbours: they are reversed"), std::string::npos)
      << made->remarks;
  for (const CloudPoint& point : made->snapshot->cloud()) ASSERT_GT(point.normal.z(), 0.0F);
}

TEST(FlipNormals, OfAClosedModelAreRefusedUnlessItIsToBeTouchedFromInside) {
  const models::PointModel mesh = ball(0.1, {0, 0, 1}, true);
  models::PointModel cloud;
  for (const CloudPoint& point : poisson_disk_samples(mesh, 4000, 3)) {
    cloud.points.push_back(point.at_m);
    cloud.normals.push_back(point.normal);
  }
  for (const auto& [model, kind] : {std::pair{mesh, "mesh"}, std::pair{cloud, "cloud"}}) {
    const auto refused = make_static_model(model, {.flip_normals = true});
    ASSERT_FALSE(refused.ok()) << kind;
    EXPECT_NE(refused.error().what.find(std::string("is a closed ") + kind), std::string::npos)
        << to_string(refused.error());
    EXPECT_NE(refused.error().fix.find("leave out --flip-normals"), std::string::npos);
    const auto hollow = make_static_model(model, {.anyway = true, .flip_normals = true});
    ASSERT_TRUE(hollow.ok()) << to_string(hollow.error());
    EXPECT_NE(hollow->remarks.find("touched from inside"), std::string::npos) << hollow->remarks;
    ASSERT_FALSE(hollow->snapshot->cloud().empty());
    for (const CloudPoint& point : hollow->snapshot->cloud()) ASSERT_LT(point.at_m.dot(point.normal), 0.0F) << kind;
  }
  ASSERT_TRUE(make_static_model(dome(), {.viewpoint_m = {0, 0, 3}, .flip_normals = true}).ok()) << "an open cloud";
}

TEST(ModelUnit, TheFixNamesTheUnitThatGivesTheSizeOfAPatient) {
  struct Row {
    double radius, unit_m;
    const char* fix;
  };
  for (const Row& row : {Row{100.0, 1.0, "unit_m=0.001,"},                     // millimetres
                         Row{0.1, 0.001, "unit_m=1,"},                         // metres, and 0.001 was given
                         Row{0.0001, 1.0, "unit_m=1000,"},                     // kilometres
                         Row{850.0, 1.0, "unit_m=0.001,"},                     // a person in millimetres
                         Row{85.0, 1.0, "0.01 (then the points span 1.7 m)"},  // a person in centimetres
                         Row{10.0, 1.0, "unit_m=0.01,"},                       // an organ in centimetres
                         Row{0.1, 1000.0, "unit_m=1,"},                        // metres, and 1000 was given
                         Row{1e9, 1.0, "no usual unit of its coordinates"}}) {
    models::PointModel mesh = ball(row.radius * row.unit_m, {0, 0, 0}, false);
    const std::optional<Error> error = models::unit_error(mesh, row.unit_m);
    ASSERT_TRUE(error) << row.radius << " " << row.unit_m;
    EXPECT_NE(error->fix.find(row.fix), std::string::npos) << row.radius << " " << row.unit_m << ": " << error->fix;
  }
  const std::optional<Error> either = models::unit_error(ball(8.5, {0, 0, 0}, false), 1.0);
  ASSERT_TRUE(either);
  EXPECT_NE(either->fix.find("0.01 (then the points span 0.17 m) or 0.1 (then the points span 1.7 m)"),
            std::string::npos)
      << either->fix;
  EXPECT_FALSE(models::unit_error(ball(0.1, {0, 0, 0}, false), 1.0));
}

TEST(CloudOrientation, AnOpenCloudThatIsTouchedFromInsideIsSaidToBeHollowAndNotReversed) {
  models::PointModel cloud = dome();
  EXPECT_EQ(make_static_model(cloud, {.viewpoint_m = {0, 0, 3}})->remarks, "");
  for (Vector3f& normal : cloud.normals) normal = -normal;
  const auto made = make_static_model(cloud, {.viewpoint_m = {0, 0, 3}});
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_NE(made->remarks.find("concave side"), std::string::npos) << made->remarks;
  EXPECT_NE(made->remarks.find("% of its normals point away from the origin"), std::string::npos) << made->remarks;
  for (const CloudPoint& point : made->snapshot->cloud()) ASSERT_LT(point.normal.z(), 0.0F);
}

TEST(MeshFiles, AnObjWithNormalsKeepsThemAndACloudOfPointsHasNone) {
  const std::string triangle = "v 0 0 1\nv 1 0 1\nv 0 1 1\nvn 0 0 -1\nvn 0 1 0\n";
  const auto mesh = models::parse_obj(bytes_of(triangle + "f 1//1 2/5/1 3//2\n"), "a.obj");
  ASSERT_TRUE(mesh.ok()) << to_string(mesh.error());
  ASSERT_EQ(mesh->normals.size(), 3U);
  EXPECT_EQ(mesh->normals[1], Vector3f(0, 0, -1));
  EXPECT_EQ(mesh->normals[2], Vector3f(0, 1, 0));
  const auto cloud = models::parse_obj(bytes_of("v 0 0 1\nv 1 0 1\nvn 0 0 -1\nvn 0 1 0\n"), "a.obj");
  ASSERT_TRUE(cloud.ok());
  EXPECT_EQ(cloud->normals.size(), 2U) << "one normal a vertex: they belong together";
  EXPECT_TRUE(models::parse_obj(bytes_of(triangle), "a.obj")->normals.empty()) << "nobody says which is whose";
}

TEST(MeshFiles, ABinaryPlyWithNormalsIsRead) {
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const auto put = [&](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    ply.append(raw, sizeof value);
  };
  for (int vertex = 0; vertex < 3; ++vertex) {
    for (const float value : {static_cast<float>(vertex), 1.0F, 2.0F, 0.0F, 0.0F, -1.0F}) put(value);
    put(std::uint8_t{9});
  }
  put(std::uint8_t{3});
  for (const std::int32_t corner : {0, 1, 2}) put(corner);
  const auto read = models::parse_ply(bytes_of(ply), "a.ply");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->points.size(), 3U);
  EXPECT_EQ(read->points[2], Vector3f(2, 1, 2));
  EXPECT_EQ(read->normals[2], Vector3f(0, 0, -1));
  EXPECT_EQ(read->triangles.size(), 1U);
  for (std::size_t cut = 0; cut < ply.size(); ++cut)
    EXPECT_FALSE(models::parse_ply(bytes_of(ply).first(cut), "a.ply").ok()) << "cut at " << cut;
}

}  // namespace
}  // namespace telepalp::surface
