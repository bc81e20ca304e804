#include "haptic_station/tissue/fem/slewed_plane.h"

#include <gtest/gtest.h>

#include <limits>

#include "haptic_station/device/random.h"
#include "tests/haptic_station/tissue/fem/hand_over.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

constexpr double kTick_N = 0.04;  // SlewSettings::slew_N_per_s over a tick

/// A tool 10 mm deep in a wall of 1400 N/m.
HandOver pressed(const SlewSettings& settings = {}) {
  HandOver hand(settings);
  hand.begin({0.001, 0, 0});
  hand.plane.take(wall(1400, 0.0));
  hand.tick({0.001, 0, 0});
  for (int i = 0; i < 200; ++i) {
    hand.plane.take(wall(1400, 0.0));
    hand.tick({0.001 - 0.011 * (i + 1) / 200, 0, 0});
  }
  return hand;
}

TEST(SlewedPlane, IsTheModelsSpringWhereTheModelStays) {
  const HandOver hand = pressed();
  EXPECT_NEAR(hand.plane.force_N(), 14.0, 1e-9);
  EXPECT_NEAR(hand.worst_step_N, 0.0, 1e-9);
  EXPECT_NEAR(hand.plane.tank().paid_J(), 0.0, 1e-12);
}

TEST(SlewedPlane, TheSameForceNeverSteps) {
  HandOver hand = pressed({.tank_J = 1.0, .tank_holds_J = 1.0});
  hand.plane.take(wall(2800, 0.001));
  hand.tick(hand.at_m);
  EXPECT_LE(hand.plane.force_N(), 14.0 + kTick_N + 1e-9);
  for (int i = 0; i < 1000; ++i) {
    hand.plane.take(wall(2800, 0.001));
    hand.tick(hand.at_m);
  }
  EXPECT_NEAR(hand.plane.force_N(), 2800 * 0.011, 1e-9) << "it arrives";
  EXPECT_LE(hand.worst_step_N, kTick_N + 1e-9);
}

TEST(SlewedPlane, AStifferModelAtTheSamePlaceCostsTheTankHalfDkXSquared) {
  for (const double slew : {8.0, 80.0, 8000.0}) {
    HandOver hand = pressed({.slew_N_per_s = slew, .held_s = 10.0});
    hand.plane.take(wall(1540, 0.0));
    hand.rest(1.0);
    EXPECT_NEAR(hand.plane.force_N(), 15.4, 1e-9);
    EXPECT_NEAR(hand.plane.tank().paid_J() - hand.plane.tank().filled_J(), 0.5 * 140 * 0.01 * 0.01, 1e-12)
        << "7 mJ, however slowly";
    EXPECT_LE(hand.worst_unbooked_J, 1e-15);
  }
}

TEST(SlewedPlane, WhatTheTankCannotPayIsNotDone) {
  HandOver hand = pressed({.held_s = 10.0, .tank_J = 0.001});
  const double before_J = hand.plane.energy_J();
  hand.plane.take(wall(2800, 0.0));
  hand.rest(1.0);
  EXPECT_NEAR(hand.plane.energy_J(), before_J + 0.001, 1e-12);
  EXPECT_LT(hand.plane.force_N(), 28.0);
  EXPECT_NEAR(hand.plane.tank().level_J(), 0.0, 1e-15);
}

TEST(SlewedPlane, ADirectionTurnsWithoutAStepAndWithoutEnergy) {
  HandOver hand = pressed({.held_s = 10.0});
  const double before_J = hand.plane.energy_J();
  const Vector3d turned = Vector3d(1.0, 0.3, 0.0).normalized();
  hand.plane.take({.normal = turned, .offset_m = turned.dot(hand.at_m) + 0.01, .stiffness_N_per_m = 1400});
  hand.rest(0.5);
  EXPECT_LT((hand.plane.normal() - turned).norm(), 1e-12);
  EXPECT_NEAR(hand.plane.energy_J(), before_J, 1e-12);
  EXPECT_LE(hand.worst_step_N, kTick_N + 1e-6);
}

TEST(SlewedPlane, AnOldModelIsHeldThenReleasedGently) {
  HandOver hand = pressed();
  hand.rest(0.09);
  EXPECT_NEAR(hand.plane.force_N(), 14.0, 1e-9) << "held";
  hand.rest(0.2);
  EXPECT_LT(hand.plane.force_N(), 14.0);
  EXPECT_GT(hand.plane.force_N(), 5.0);
  hand.rest(1.0);
  EXPECT_EQ(hand.plane.force_N(), 0.0);
  hand.move({-0.05, 0, 0}, 0.1);
  EXPECT_EQ(hand.plane.force_N(), 0.0) << "no model, no force";
  EXPECT_LE(hand.worst_step_N, 0.011);
}

/// At 0.1 m/s a spring of 1400 N/m gains 0.07 N per tick: more than a release lowers.
TEST(SlewedPlane, AReleasedForceFallsAlsoWhileTheToolGoesDeeper) {
  for (const LocalPlane& model : {LocalPlane{}, wall(1400, 0.0)}) {
    HandOver hand = pressed({.held_s = 10.0});
    LocalPlane other = model;
    other.normal *= -1.0;
    other.offset_m = -0.5;
    hand.plane.take(other);
    hand.move({-0.04, 0, 0}, 0.1);
    EXPECT_EQ(hand.plane.force_N(), 0.0);
    EXPECT_LE(hand.worst_step_N, kTick_N + 1e-9);
    EXPECT_LE(hand.worst_unbooked_J, 1e-15);
  }
  HandOver hand = pressed();
  hand.move({-0.21, 0, 0}, 0.1);
  EXPECT_EQ(hand.plane.force_N(), 0.0) << "the model is too old";
}

TEST(SlewedPlane, AfterAReleaseANewModelIsFeltGradually) {
  HandOver hand = pressed();
  hand.rest(2.0);
  hand.worst_step_N = 0.0;
  for (int i = 0; i < 1000; ++i) {
    hand.plane.take(wall(1400, 0.0));
    hand.tick(hand.at_m);
  }
  EXPECT_GT(hand.plane.force_N(), 13.0);
  EXPECT_LE(hand.worst_step_N, kTick_N + 1e-9);
  EXPECT_LE(hand.worst_unbooked_J, 1e-15);
}

TEST(SlewedPlane, ModelsThatAreNoNumbersAreIgnored) {
  HandOver hand = pressed();
  LocalPlane bad = wall(1400, 0.0);
  bad.offset_m = std::nan("");
  hand.plane.take(bad);
  hand.plane.take(wall(std::numeric_limits<double>::infinity(), 0.0));
  hand.plane.take(wall(-5.0, 0.0));
  hand.tick(hand.at_m);
  EXPECT_NEAR(hand.plane.force_N(), 14.0, 1e-9);
}

TEST(SlewedPlane, ForceThatWasNotDisplayedFillsNoTank) {
  HandOver shown = pressed({.held_s = 10.0});
  HandOver hidden = pressed({.held_s = 10.0});
  shown.plane.take(wall(1400, -0.01));
  hidden.plane.take(wall(1400, -0.01));
  shown.rest(1.0);
  hidden.rest(1.0, 0.5);
  EXPECT_NEAR(shown.plane.tank().filled_J(), 0.07, 1e-9);
  EXPECT_NEAR(hidden.plane.tank().filled_J(), 0.5 * 0.07, 1e-3) << "half of the force does half of the work";
}

/// Any models, at any time, on any way: every joule that they add is booked, the tank is never below zero, and a hand
/// gets no more out of all of them than the tank had at first.
TEST(SlewedPlane, BooksWhatRandomModelsAdd) {
  device::Random random(11);
  HandOver hand;
  hand.begin(Vector3d::Zero());
  for (int i = 0; i < 20000; ++i) {
    if (random.uniform() < 0.03) {
      const Vector3d normal = Vector3d(1.0, random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)).normalized() *
                              (random.uniform() < 0.1 ? -1.0 : 1.0);
      LocalPlane model{
          .normal = normal, .offset_m = random.uniform(-0.005, 0.01), .stiffness_N_per_m = random.uniform(100, 3000)};
      hand.plane.take(random.uniform() < 0.1 ? LocalPlane{} : model);
    }
    hand.tick(hand.at_m + 1e-4 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    ASSERT_LE(hand.all_added_J, 0.02 + 1e-12) << "tick " << i;
  }
  EXPECT_LE(hand.worst_unbooked_J, 1e-12);
  EXPECT_GE(hand.least_level_J, 0.0);
  EXPECT_LE(hand.worst_step_N, kTick_N + 1e-6);
}

TEST(SlewedPlane, TouchesNoHeap) {
  HandOver hand = pressed();
  const test::NoHeapScope guard;
  for (int i = 0; i < 1000; ++i) {
    hand.plane.take(wall(1400 + i, 0.0));
    hand.tick({-0.01 + 1e-5 * (i % 7), 0, 0});
  }
}

}  // namespace
}  // namespace telepalp::tissue
