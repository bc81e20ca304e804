#include "haptic_station/tissue/layered_tissue.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/tissue/needle_paths.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

TEST(LayeredTissue, TheSurfacePushesBackAndIsPuncturedAtItsThreshold) {
  Insertion run(one_surface());
  double most_N = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    run.tick({0.0, -1e-5 * i, 0.0});
    if (run.tissue.layer(0).state == LayerState::Touching) {
      ASSERT_NEAR(run.force_N.y(), 300.0 * 1e-5 * i, 0.003 * 300.0 * 1e-5 * i + 1e-9) << "S4 eq. (2), at " << i;
      most_N = std::max(most_N, run.force_N.y());
    }
  }
  EXPECT_NEAR(most_N, 1.5, 0.01);
  EXPECT_EQ(run.tissue.layer(0).state, LayerState::Inserted);
  EXPECT_TRUE(run.tissue.punctured(0));
  EXPECT_NEAR(run.force_N.y(), 0.3, 0.01) << "S4 eq. (3): the hole's friction";
}

TEST(LayeredTissue, AfterThePunctureTheForceFallsOverAtLeastThreeTicks) {
  Insertion run(one_surface(1.5, 0.0));
  double last_N = 0.0;
  double steepest_N = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    run.tick({0.0, -1e-5 * i, 0.0});
    steepest_N = std::max(steepest_N, last_N - run.force_N.y());
    last_N = run.force_N.y();
  }
  EXPECT_LE(steepest_N, 1.5 / 3.0);
  EXPECT_EQ(last_N, 0.0);
}

TEST(LayeredTissue, TheHoleDragsAgainstAnyMotionAndHoldsANeedleAtRest) {
  for (const Vector3d& towards : {Vector3d(0, -1, 0), Vector3d(0, 1, 0), Vector3d(1, 0, 0), Vector3d(0, -0.6, 0.8)}) {
    Insertion run(one_surface());
    run.move({0.0, -0.03, 0.0});
    run.move(run.needle.tip_m + 0.005 * towards);
    EXPECT_LT((run.force_N + 0.3 * towards).norm(), 0.01) << "S4 eq. (7): -C v / |v|";
    const Vector3d moving_N = run.force_N;
    for (int i = 0; i < 2000; ++i) {
      run.tick(run.needle.tip_m);
      ASSERT_EQ(run.force_N, moving_N) << "no chatter and no drift at zero velocity";
    }
  }
}

TEST(LayeredTissue, ANeedleThatComesBackToItsHoleFeelsNoSecondPuncture) {
  Insertion run(one_surface());
  run.move({0.0, -0.02, 0.0});
  run.move({0.0, 0.005, 0.0});
  EXPECT_EQ(run.tissue.layer(0).state, LayerState::Removed);
  EXPECT_EQ(run.force_N, Vector3d::Zero());
  run.tissue.begin(run.needle);  // the next contact
  double most_N = 0.0;
  for (int i = 0; i < 1000; ++i) {
    run.tick({0.0, 0.005 - 2e-5 * i, 0.0});
    most_N = std::max(most_N, run.force_N.norm());
  }
  EXPECT_LE(most_N, 0.3 + 1e-9) << "friction alone";
  run.move({0.0, 0.005, 0.0});
  run.move({0.01, 0.005, 0.0});
  most_N = 0.0;
  for (int i = 0; i < 1000; ++i) {
    run.tick({0.01, 0.005 - 2e-5 * i, 0.0});
    most_N = std::max(most_N, run.force_N.norm());
  }
  EXPECT_NEAR(most_N, 1.5, 0.02) << "10 mm beside the hole the surface is whole";
}

TEST(LayeredTissue, LayersAddUpAndAreOpenedFromTheOutside) {
  Insertion run(three_layers());
  bool together = false;
  for (int i = 0; i < 5000; ++i) {
    run.tick({0.0, 0.001 - 1e-5 * i, 0.0});
    Vector3d sum_N = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) sum_N += run.tissue.layer(k).force_N;
    ASSERT_NEAR(run.force_N.y(), sum_N.y(), 1e-12) << "S4 eq. (1)";
    ASSERT_TRUE(run.tissue.layer(2).state != LayerState::Inserted || run.tissue.layer(0).state == LayerState::Inserted);
    together = together || (run.tissue.layer(1).force_N.y() > 0.1 && run.tissue.layer(2).force_N.y() > 0.1);
  }
  EXPECT_TRUE(together);
  EXPECT_EQ(run.tissue.layer(2).state, LayerState::Inserted);
}

TEST(LayeredTissue, GivesNoEnergyOverAHundredThousandStepsAtTenTimesTheStiffness) {
  for (const BulkLaw law : {BulkLaw::Bristle, BulkLaw::Window, BulkLaw::Paper})
    for (const double stiff : {1.0, 10.0})
      for (const std::uint64_t seed : {1, 2}) {
        Insertion run(three_layers(stiff, law));
        wander(run, 100'000, seed);
        EXPECT_LE(run.worst_gain_J, 0.0) << "seed " << seed;
        EXPECT_LE(run.tissue.stored_J() - run.held_J, 0.0) << "with held forces, seed " << seed;
        EXPECT_LE(run.worst_step_N, 0.05) << "seed " << seed;
        EXPECT_GT(run.taken_J, 0.1) << "it felt the tissue";
      }
}

TEST(LayeredTissue, AtAPunctureTheNetsEnergyIsReleasedOrDissipated) {
  for (const double speed_m_per_s : {0.002, 0.05, -0.05}) {
    Insertion run(one_surface(1.5, 0.0));
    Vector3d to_m{0.002, 0.005, 0.0};
    run.tissue.begin(run.needle);
    while (run.tissue.layer(0).state != LayerState::Inserted) run.tick(to_m -= Vector3d(0.0, 1e-5, 0.0));
    const double before_J = run.tissue.stored_J();
    const double taken_J = run.taken_J;
    for (int i = 0; i < 60; ++i) run.tick(to_m -= Vector3d(0.0, speed_m_per_s * kTick_s, 0.0));
    const double released_J = taken_J - run.taken_J;
    EXPECT_NEAR(before_J, released_J + run.tissue.punctures_dissipated_J() + run.tissue.stored_J(), 0.01 * before_J);
    EXPECT_LE(run.tissue.stored_J(), 1e-12);
  }
}

TEST(LayeredTissue, ANetThatYieldedOrRelaxedStoresNothingMoreWhileTheTipLeaves) {
  TissueSettings tissue = one_surface(50.0);
  tissue.layers[0].relaxation = {.branches = 1, .share = {0.6}, .time_s = {0.5}};
  Insertion run(tissue);
  run.move({0.0, -0.02, 0.0});
  run.rest(2.0);
  run.tissue.yield(0.2);
  const double yielded_J = run.tissue.stored_J();
  double before_J = yielded_J;
  for (int i = 0; i < 1900; ++i) {
    run.tick(run.needle.tip_m + Vector3d(0.0, 1e-5, 0.0));
    ASSERT_GE(run.force_N.y(), 0.0) << "it does not pull";
    ASSERT_LE(run.tissue.stored_J(), before_J + 1e-12);
    before_J = run.tissue.stored_J();
  }
  EXPECT_LT(before_J, 0.3 * yielded_J);
  run.move({0.0, -0.004, 0.0});
  EXPECT_GT(run.force_N.y(), 0.3) << "and pushes again when the tip comes back";
}

TEST(LayeredTissue, AStoppedNeedleRelaxes) {
  TissueSettings tissue = one_surface(5.0);
  tissue.layers[0].relaxation = {.branches = 2, .share = {0.2, 0.3}, .time_s = {0.1, 1.0}};
  Insertion run(tissue);
  run.move({0.0, -0.005, 0.0}, 5.0);
  const double first_N = run.force_N.y();
  run.rest(0.1);
  EXPECT_NEAR(run.force_N.y() / first_N, 0.5 + 0.2 * std::exp(-1.0) + 0.3 * std::exp(-0.1), 0.002);
  run.rest(20.0);
  EXPECT_NEAR(run.force_N.y() / first_N, 0.5, 0.001);
}

TEST(LayeredTissue, TheHoleHoldsTheShaftAsALeverThatIsTheGradientOfItsEnergy) {
  TissueSettings tissue = one_surface(1.5, 0.0);
  tissue.shaft = {.side_N_per_m = 200.0, .tears_at_N_per_m = 1000.0, .bevel_rad = 0.0};
  Insertion run(tissue);
  run.move({0.0, -0.04, 0.0});
  run.move({0.003, -0.04, 0.0});
  EXPECT_NEAR(run.force_N.x(), -200.0 * 0.003, 1e-6) << "sideways stiffness at the hole";
  EXPECT_NEAR(run.tissue.wrench().torque_N_m.z(), 0.04 * 200.0 * 0.003, 1e-6) << "with a lever of 40 mm to the tip";
  const auto energy_J = [&](const Vector3d& by_m, const Vector3d& by_rad) {
    LayeredTissue copy = run.tissue;
    NeedleMotion needle = run.needle;
    needle.tip_m += by_m;
    if (by_rad.norm() > 0.0) needle.axis = Eigen::AngleAxisd(by_rad.norm(), by_rad.normalized()) * needle.axis;
    (void)copy.step(needle, kTick_s);
    return copy.stored_J();
  };
  const TissueWrench wrench = run.tissue.wrench();
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d hop = 1e-6 * Vector3d::Unit(axis);
    const Vector3d none = Vector3d::Zero();
    EXPECT_NEAR(wrench.force_N[axis], -(energy_J(hop, none) - energy_J(-hop, none)) / 2e-6, 1e-4);
    EXPECT_NEAR(wrench.torque_N_m[axis], -(energy_J(none, hop) - energy_J(none, -hop)) / 2e-6, 1e-4);
  }
}

TEST(LayeredTissue, AStepUsesNoHeap) {
  if (!test::NoHeapScope::works()) GTEST_SKIP() << "the sanitizer owns malloc";
  LayeredTissue tissue(*make_tissue(three_layers()));
  NeedleMotion needle;
  needle.tip_m = {0.0, 0.005, 0.0};
  tissue.begin(needle);
  const test::NoHeapScope guard;
  for (int i = 0; i < 10'000; ++i) {
    needle.tip_m = {0.01 * std::sin(0.002 * i), 0.005 - 0.03 * (1.0 - std::cos(0.003 * i)), 0.0};
    (void)tissue.step(needle, kTick_s);
  }
}

}  // namespace
}  // namespace telepalp::tissue
