#include <gtest/gtest.h>

#include <memory>

#include "haptic_station/device/random.h"
#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/effects/inner_cylinder.h"
#include "haptic_station/effects/inner_sphere.h"
#include "haptic_station/effects/organ.h"

namespace telepalp::effects {
namespace {

EffectInput at(const Eigen::Vector3d& device) {
  EffectInput in;
  in.device.m = device;
  in.contact.normal.v = Eigen::Vector3d::UnitY();
  return in;
}

InnerCylinder paper_cylinder() { return InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}); }

TEST(InnerCylinder, PushesUpFromItsUpperFaceWithStiffnessTimesDepth) {
  InnerCylinder cylinder = paper_cylinder();
  const Eigen::Vector3d force_N = cylinder.step(at({0.005, -0.038, 0.0}), 0.0005).N;
  EXPECT_NEAR(force_N.y(), 800.0 * 0.008, 0.005 * 800.0 * 0.008);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::Upper);
}

TEST(InnerCylinder, PushesSidewaysFromItsLateralFace) {
  InnerCylinder cylinder = paper_cylinder();
  const Eigen::Vector3d force_N = cylinder.step(at({0.024, -0.055, 0.0}), 0.0005).N;
  EXPECT_NEAR(force_N.x(), 800.0 * 0.006, 0.005 * 800.0 * 0.006);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::Lateral);
}

TEST(InnerCylinder, ReportsNearAndAway) {
  InnerCylinder cylinder = paper_cylinder();
  EXPECT_EQ(cylinder.step(at({0.0, -0.025, 0.0}), 0.0005).N.norm(), 0.0);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::Near);
  (void)cylinder.step(at({0.0, -0.01, 0.0}), 0.0005);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::None);
}

TEST(InnerCylinder, ForceIsContinuousAndTheGradientOfItsEnergyEverywhere) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE(kSeed);
  device::Random random(kSeed);
  InnerCylinder cylinder = paper_cylinder();
  const auto force = [&](const Eigen::Vector3d& p) { return cylinder.step(at(p), 0.0005).N; };  // of one entry side
  const auto energy = [&](const Eigen::Vector3d& p) { return (void)force(p), cylinder.energy_J(); };
  constexpr double kStep_m = 1e-6;
  for (int i = 0; i < 20'000; ++i) {
    const Eigen::Vector3d p{random.uniform(-0.04, 0.04), random.uniform(-0.09, -0.02), random.uniform(-0.04, 0.04)};
    cylinder.begin(at(p));
    const Eigen::Vector3d here_N = force(p);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = Eigen::Vector3d::Unit(axis) * kStep_m;
      ASSERT_LE((force(p + step) - here_N).norm(), 0.05) << p.transpose();  // 50 kN/m: no step at any rim
      const double slope = (energy(p + step) - energy(p - step)) / (2.0 * kStep_m);
      ASSERT_NEAR(here_N[axis], -slope, 0.01 + 0.01 * here_N.norm()) << p.transpose();
    }
  }
}

TEST(InnerSphere, PushesOutwardsWithStiffnessTimesDepth) {
  InnerSphere sphere({.center = {{0.0, -0.05, 0.0}}});
  for (const double depth_m : {0.001, 0.01, 0.018}) {
    const Eigen::Vector3d force_N = sphere.step(at({0.0, -0.03 - depth_m, 0.0}), 0.0005).N;
    EXPECT_NEAR(force_N.y(), 800.0 * depth_m, 1e-9);
    EXPECT_EQ(sphere.touch(), ObjectTouch::Upper);
  }
  EXPECT_LE(sphere.step(at({0.0, -0.05, 0.0}), 0.0005).N.norm(), 1e-9) << "the centre has no direction";
}

TEST(InnerObjects, ForgetTheSideOfEntryWhenTheHandHasLeft) {
  InnerSphere sphere({.center = {{0.0, -0.05, 0.0}}});
  const auto from = [&](double y_m, double to_m) {
    Eigen::Vector3d last_N = Eigen::Vector3d::Zero();
    for (int i = 0; i <= 1000; ++i) last_N = sphere.step(at({0.004, y_m + (to_m - y_m) * i / 1000.0, 0.0}), 0.0005).N;
    return last_N;
  };
  EXPECT_GT(from(-0.02, -0.06).x(), 5.0) << "past the centre it pushes sideways";
  EXPECT_EQ(from(-0.06, -0.09).norm(), 0.0) << "it has faded behind the far face";
  EXPECT_LT(from(-0.09, -0.06).y(), -5.0) << "from below, it is as solid as from above";
}

/// A shape with its stiffness of 800 N/m, about (0, -0.05, 0), and one way through it.
struct WayThrough {
  const char* name;
  Eigen::Vector3d from_m;
  Eigen::Vector3d to_m;
};

const WayThrough kWaysThrough[] = {
    {"from above, through the middle", {0.0, -0.01, 0.0}, {0.0, -0.12, 0.0}},
    {"from above, 4 mm beside", {0.004, -0.01, 0.0}, {0.004, -0.12, 0.0}},
    {"from above, 15 mm beside", {0.0, -0.01, 0.015}, {0.0, -0.12, 0.015}},
    {"from the side", {0.06, -0.052, 0.003}, {-0.06, -0.052, 0.003}},
    {"from below", {0.002, -0.12, 0.001}, {0.002, -0.01, 0.001}},
};

/// Least force against the push, largest change of force over 0.02 mm, and what the hand got out beyond what it gave.
struct Passed {
  double least_N = 1e9;
  double step_N = 0.0;
  double gained_J = 0.0;
  double most_N = 0.0;
};

template <class Effect>
Passed pass(Effect& effect, const WayThrough& way) {
  constexpr int kSteps = 6000;
  const Eigen::Vector3d push = (way.to_m - way.from_m).normalized();
  const Eigen::Vector3d hop = (way.to_m - way.from_m) / kSteps;
  Passed passed;
  Eigen::Vector3d last_N = Eigen::Vector3d::Zero();
  double given_J = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const Eigen::Vector3d force_N = effect.step(at(way.from_m + hop * i), 0.0005).N;
    passed.least_N = std::min(passed.least_N, -force_N.dot(push));
    passed.step_N = std::max(passed.step_N, (force_N - last_N).norm());
    passed.most_N = std::max(passed.most_N, force_N.norm());
    given_J -= 0.5 * (force_N + last_N).dot(hop);
    passed.gained_J = std::max(passed.gained_J, effect.energy_J() - given_J);
    last_N = force_N;
  }
  return passed;
}

/// A ball of 25 mm as an organ's shape.
std::shared_ptr<const solids::DistanceLattice> ball_lattice() {
  constexpr int kNodes = 40;
  auto lattice = std::make_shared<solids::DistanceLattice>();
  lattice->spacing_m = 0.002;
  lattice->size = {kNodes, kNodes, kNodes};
  lattice->origin_m = Eigen::Vector3d{0.0, -0.05, 0.0} - Eigen::Vector3d::Constant(0.5 * 0.002 * (kNodes - 1));
  for (int k = 0; k < kNodes; ++k)
    for (int j = 0; j < kNodes; ++j)
      for (int i = 0; i < kNodes; ++i)
        lattice->nodes_m.push_back(static_cast<float>(
            (lattice->origin_m + 0.002 * Eigen::Vector3d(i, j, k) - Eigen::Vector3d{0.0, -0.05, 0.0}).norm() - 0.025));
  return lattice;
}

TEST(InnerObjects, NeverPullAHandThatPushesThrough) {
  for (const WayThrough& way : kWaysThrough) {
    SCOPED_TRACE(way.name);
    InnerSphere sphere({.center = {{0.0, -0.05, 0.0}}});
    InnerCylinder cylinder({.top_center = {{0.0, -0.03, 0.0}}});
    Organ organ({.shape = ball_lattice(), .stiffness_N_per_m = 800.0});
    for (const Passed& passed : {pass(sphere, way), pass(cylinder, way), pass(organ, way)}) {
      EXPECT_GE(passed.least_N, -1e-3);
      EXPECT_LE(passed.step_N, 0.3) << "over 0.02 mm";
      EXPECT_LE(passed.gained_J, 1e-4);
      EXPECT_GE(passed.most_N, 3.0) << "it is felt";
    }
  }
}

TEST(InnerObjects, GiveNoEnergyOnAnyPath) {
  constexpr std::uint64_t kSeed = 3;
  SCOPED_TRACE(kSeed);
  device::Random random(kSeed);
  InnerSphere sphere({.center = {{0.0, -0.05, 0.0}}});
  InnerCylinder cylinder({.top_center = {{0.0, -0.03, 0.0}}});
  Organ organ({.shape = ball_lattice(), .stiffness_N_per_m = 800.0});
  const auto worst_J = [&](auto& effect) {
    double stored_less_given_J = 0.0;
    double worst = 0.0;
    Eigen::Vector3d here{0.0, -0.01, 0.0};
    Eigen::Vector3d last_N = Eigen::Vector3d::Zero();
    for (int leg = 0; leg < 150; ++leg) {
      const Eigen::Vector3d there{random.uniform(-0.03, 0.03), random.uniform(-0.09, -0.01),
                                  random.uniform(-0.03, 0.03)};
      const Eigen::Vector3d hop = (there - here) / 2000.0;
      for (int i = 0; i < 2000; ++i) {
        here += hop;
        const Eigen::Vector3d force_N = effect.step(at(here), 0.0005).N;
        stored_less_given_J += 0.5 * (force_N + last_N).dot(hop);
        worst = std::max(worst, stored_less_given_J + effect.energy_J());
        last_N = force_N;
      }
    }
    return worst;
  };
  EXPECT_LE(worst_J(sphere), 1e-3);
  EXPECT_LE(worst_J(cylinder), 1e-3);
  EXPECT_LE(worst_J(organ), 1e-3);
}

TEST(EffectBank, DisplacesTheObjectsInsideTheBodyAlone) {
  EffectBank bank;
  (void)bank.add(Skin{});
  (void)bank.add(InnerSphere({.center = {{0.0, -0.05, 0.0}}}));
  EXPECT_FALSE(bank.object_at(0));
  ASSERT_TRUE(bank.object_at(1));
  EXPECT_EQ(bank.object_at(1)->m, Eigen::Vector3d(0.0, -0.05, 0.0));
  EXPECT_FALSE(bank.object_at(2)) << "there is no third effect";
  Placements placements{};
  placements[1].moved.v = {0.01, 0.02, 0.0};
  bank.place(placements);
  const auto sphere_N = [&](double y_m) {
    const Eigen::Vector3d both_N = bank.step(at({0.01, y_m, 0.0}), 0.0005).force.N;
    return (both_N - skin_force_N(SkinLaw{}, bank.indentation().v)).eval();
  };
  bank.begin(at({0.01, 0.0, 0.0}));
  EXPECT_NEAR(sphere_N(-0.005).norm(), 0.0, 1e-9);
  EXPECT_NEAR(sphere_N(-0.015).y(), 800.0 * 0.005, 1e-9);
}

TEST(EffectBank, AnObjectThatCarriesTheHandAlongTakesNoEnergyFromIt) {
  EffectBank bank;
  (void)bank.add(InnerSphere({.center = {{0.0, -0.05, 0.0}}}));
  double absorbed_J = 0.0;
  for (int i = 0; i < 2000; ++i) {
    Placements placements{};
    placements[0] = {.moved = {{0.0, 1e-5 * i, 0.0}}, .velocity = {{0.0, 0.02, 0.0}}};
    bank.place(placements);
    EffectInput in = at({0.0, -0.035 + 1e-5 * i, 0.0});
    in.moved.v = {0.0, 1e-5, 0.0};
    (void)bank.step(in, 0.0005);
    if (i > 0) absorbed_J += bank.absorbed_J();
  }
  EXPECT_NEAR(absorbed_J, 0.0, 1e-4);
}

}  // namespace
}  // namespace telepalp::effects
