#include <gtest/gtest.h>

#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

TissueSettings one_bulk(const BulkSettings& bulk) {
  TissueSettings tissue;
  tissue.net_edge_m = 0.005;
  tissue.layers = {{.name = "muscle", .thickness_m = 0.1, .surface = {}, .bulk = bulk, .relaxation = {}}};
  return tissue;
}

TEST(Bulk, ByTheLawsOfS4ASpringHoldsANeedleThatStoppedAndADamperOneThatSlips) {
  for (const BulkLaw law : {BulkLaw::Window, BulkLaw::Paper}) {
    Insertion run(one_bulk({.law = law, .stick_N_per_m = 500.0, .slips_at_N = 0.5, .damping_N_s_per_m = 4.0}));
    run.move({0.0, -0.03, 0.0}, 0.05);
    EXPECT_NEAR(run.force_N.y(), 4.0 * 0.05, 0.002) << "eq. (5)";
    run.rest(0.1);
    EXPECT_NEAR(run.force_N.y(), 0.0, 1e-6) << "the spring begins where the needle stopped";
    run.move({0.0, -0.0305, 0.0}, 0.02);
    EXPECT_NEAR(run.force_N.y(), 500.0 * 0.0005, 1e-6) << "eq. (4)";
    run.rest(1.0);
    EXPECT_NEAR(run.force_N.y(), 500.0 * 0.0005, 1e-6) << "and holds";
    run.move({0.0, -0.05, 0.0}, 0.05);
    EXPECT_NEAR(run.force_N.y(), 4.0 * 0.05, 0.002) << "above the threshold it slips again";
  }
}

/// A needle at 20 um/s moves 0.4 um in 20 ms: a coarse device reports equal coordinates, and a fine one does not.
TEST(Bulk, OnlyWithTheRuleOfThePaperStoppedDependsOnTheResolutionOfTheDevice) {
  const auto sticks = [](BulkLaw law, double resolution_m) {
    Insertion run(one_bulk({.law = law, .stick_N_per_m = 500.0, .slips_at_N = 0.5, .resolution_m = resolution_m}));
    run.move({0.0, -0.03, 0.0}, 0.05);
    run.move({0.0, -0.03002, 0.0}, 2e-5);
    run.move({0.0, -0.0305, 0.0}, 0.02);
    return run.force_N.y() > 0.15;
  };
  EXPECT_TRUE(sticks(BulkLaw::Paper, 3e-5));
  EXPECT_FALSE(sticks(BulkLaw::Paper, 1e-7));
  EXPECT_TRUE(sticks(BulkLaw::Window, 3e-5));
  EXPECT_TRUE(sticks(BulkLaw::Window, 1e-7));
}

TEST(Bulk, TheBristleGrowsWithTheLengthInsideAndNeitherCreepsNorDrifts) {
  Insertion run(one_bulk({.slips_at_N = 0.0, .slips_at_N_per_m = 11.3}));
  run.move({0.0, -0.08, 0.0}, 0.02);
  EXPECT_NEAR(run.force_N.y(), 11.3 * 0.08, 0.005);
  const double moving_N = run.force_N.y();
  run.rest(5.0);
  EXPECT_EQ(run.force_N.y(), moving_N);
  run.move({0.0, -0.0799, 0.0}, 0.02);
  EXPECT_NEAR((moving_N - run.force_N.y()) / 1e-4, 1000.0, 1.0) << "pre-sliding stiffness at the reversal";
  run.move({0.0, -0.0796, 0.0}, 0.02);
  const double held_N = run.force_N.y();
  for (int i = 0; i < 20'000; ++i) run.tick({0.0, -0.0796 + (i % 2 == 0 ? 1e-5 : 0.0), 0.0});
  EXPECT_NEAR(run.force_N.y(), held_N, 1e-9) << "a tremor of 10 um does not make it drift";
}

TEST(Bulk, TissueIsCutOnce) {
  Insertion run(one_bulk({.slips_at_N = 0.0, .slips_at_N_per_m = 10.0, .cuts_at_N = 0.6}));
  run.move({0.0, -0.04, 0.0}, 0.02);
  EXPECT_NEAR(run.force_N.y(), 0.6 + 0.4, 0.01);
  run.move({0.0, -0.02, 0.0}, 0.02);
  EXPECT_NEAR(run.force_N.y(), -0.2, 0.01) << "friction alone on the way out";
  run.move({0.0, -0.035, 0.0}, 0.02);
  EXPECT_NEAR(run.force_N.y(), 0.35, 0.01) << "and on the way that is cut";
  run.move({0.0, -0.06, 0.0}, 0.02);
  EXPECT_NEAR(run.force_N.y(), 0.6 + 0.6, 0.01);
}

TEST(Bulk, ABevelTurnsTheForceOfCutting) {
  TissueSettings tissue = one_bulk({.slips_at_N = 0.0, .cuts_at_N = 0.6});
  tissue.shaft.bevel_rad = 0.35;
  Insertion run(tissue);
  run.move({0.0, -0.04, 0.0}, 0.02);
  EXPECT_NEAR(run.force_N.y(), 0.6 * std::cos(0.35), 0.01);
  EXPECT_NEAR(run.force_N.x(), -0.6 * std::sin(0.35), 0.01);
}

}  // namespace
}  // namespace telepalp::tissue
