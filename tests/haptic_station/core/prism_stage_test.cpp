// A soft prism in a bank of effects, with its slow stage in virtual time.

#include "haptic_station/core/prism_stage.h"

#include <gtest/gtest.h>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/virtual_effects.h"
#include "haptic_station/tissue/fem/prism_model.h"
#include "tests/haptic_station/periods.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp::core {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

effects::Recipe prism(double coupling_N_per_m = 0.0) {
  tissue::PrismSettings settings;
  settings.grid.across = 1;
  settings.grid.along = 4;
  settings.coupling_N_per_m = coupling_N_per_m;
  return effects::FemPrismSettings{.model = *tissue::make_prism_model(settings), .slew = {}};
}

/// A bank whose device point is moved, with two ledgers: the bank's own, and the work of the force that it gives.
struct Hand {
  explicit Hand(const effects::Recipe& recipe) : Hand(build_effects(std::vector<effects::Recipe>{recipe})) {}
  explicit Hand(BuiltEffects built) : bank(built.bank), slow(std::move(built.stages)) { bank.begin(in); }

  void tick(const Vector3d& to_m, double most_N = 100.0) {
    slow.advance(now, {in.device}, 10ms);
    in.moved.v = to_m - in.device.m;
    in.device.m = to_m;
    const Vector3d held_N = force_N;
    force_N = bank.step(in, kTick_s, most_N).force.N;
    got_J += held_N.dot(in.moved.v);
    sampled_J += 0.5 * (force_N - held_N).dot(in.moved.v);
    absorbed_J += bank.absorbed_J();
    least_ledger_J = std::min(least_ledger_J, absorbed_J - bank.energy_J() - sampled_J);
    now += 500us;
  }
  void move(const Vector3d& to_m, double speed_m_per_s = 0.1, double most_N = 100.0) {
    const Vector3d from_m = in.device.m;
    const int ticks = std::max(1, static_cast<int>((to_m - from_m).norm() / (speed_m_per_s * kTick_s)));
    for (int i = 1; i <= ticks; ++i) tick(from_m + (to_m - from_m) * i / ticks, most_N);
  }
  void rest(double seconds, double most_N = 100.0) {
    for (double t = 0.0; t < seconds; t += kTick_s) tick(in.device.m, most_N);
  }

  effects::EffectBank bank;
  VirtualEffects slow;
  effects::EffectInput in = [] {
    effects::EffectInput at;
    at.device.m = {0.03, 0.09, 0.0};
    return at;
  }();
  SessionTime now{10s};
  Vector3d force_N = Vector3d::Zero();
  double got_J = 0.0;       ///< by the hand, from the held force
  double sampled_J = 0.0;   ///< of the hand's work, what a force that is held over a tick adds to a continuous one
  double absorbed_J = 0.0;  ///< by the effects, as the bank says
  double least_ledger_J = 0.0;
};

TEST(PrismStage, APushedPrismPushesBackWithItsOwnStiffness) {
  Hand hand(prism());
  hand.rest(0.1);
  hand.move({0.0, 0.09, 0.0});
  hand.rest(0.5);
  EXPECT_GT(hand.force_N.x(), 8.0);
  EXPECT_LT(hand.force_N.x(), 25.0);
  hand.move({0.03, 0.09, 0.0});
  hand.rest(0.1);
  EXPECT_EQ(hand.force_N.norm(), 0.0);
}

TEST(PrismStage, S3sCouplingIsFeltInSeries) {
  Hand hand(prism(200.0));
  hand.rest(0.1);
  hand.move({0.0, 0.095, 0.0});
  hand.rest(0.5);
  EXPECT_NEAR(hand.force_N.x() / 0.01, 175.0, 20.0);
}

/// The ledger of a hand that presses, rubs and leaves, for ten rounds: nothing but sampling and the tank's first level
/// may be missing at any time, and the hand gains no energy by a closed path.
TEST(PrismStage, TheBanksLedgerHoldsWhatNewModelsAdd) {
  Hand hand(prism());
  hand.rest(0.1);
  for (int round = 0; round < 10; ++round) {
    hand.move({0.002, 0.095, 0.0}, 0.15);
    hand.move({0.003, 0.08, 0.004}, 0.1);
    hand.move({0.0, 0.09, -0.004}, 0.1);
    hand.move({0.03, 0.09, 0.0}, 0.3);
    hand.rest(0.05);
  }
  EXPECT_NEAR(hand.got_J, -hand.absorbed_J, 1e-12);
  EXPECT_GT(hand.least_ledger_J, -1e-3) << "each joule of the springs was absorbed, or taken from the tank";
  EXPECT_LT(hand.got_J - hand.sampled_J, 0.02 + 1e-3);
}

TEST(PrismStage, UnderALimitedForceNoEnergyAppears) {
  Hand hand(prism());
  hand.rest(0.1, 3.0);
  for (int round = 0; round < 5; ++round) {
    hand.move({0.0, 0.09, 0.0}, 0.1, 3.0);
    hand.rest(0.2, 3.0);
    hand.move({0.03, 0.09, 0.0}, 0.1, 3.0);
    hand.rest(0.05, 3.0);
  }
  EXPECT_LT(hand.got_J - hand.sampled_J, 0.02 + 1e-3);
}

TEST(PrismStage, ItsEffectTouchesNoHeap) {
  BuiltEffects built = build_effects(std::vector<effects::Recipe>{prism()});
  effects::EffectInput in;
  in.device.m = {0.012, 0.09, 0.0};
  const auto job = built.stages.front()->take(SessionTime{10s}, {in.device});
  built.stages.front()->hand_over(built.stages.front()->run(*job, [](StageStep) { return SessionTime{10s}; }));
  const test::NoHeapScope guard;
  built.bank.begin(in);
  for (int i = 0; i < 100; ++i) {
    in.device.m.x() -= 1e-5;
    (void)built.bank.step(in, kTick_s, 10.0);
  }
}

/// A tool that slides along the prism's side. The contact point of the model tells where it is expected.
TEST(PrismStage, ItsModelIsThatOfWhereTheToolWillBe) {
  PrismStage stage(std::get<effects::FemPrismSettings>(prism()));
  const auto height_m = [&stage](double tool_m, Nanoseconds at) {
    const ModelWanted wanted{
        .tool = {.device = {{0.015, tool_m, 0.0}}}, .begun = SessionTime{at}, .displayed_in = 20ms};
    return stage.model_at(wanted)->at_m.y();
  };
  EXPECT_NEAR(height_m(0.05, 1000ms), 0.05, 1e-9) << "nothing is known of its velocity";
  EXPECT_NEAR(height_m(0.0516, 1016ms), 0.0536, 1e-9) << "0.1 m/s";
  EXPECT_NEAR(height_m(0.0616, 1416ms), 0.0616, 1e-9) << "it was not seen for 0.4 s";
  EXPECT_NEAR(height_m(0.0816, 1432ms), 0.0816, 1e-9) << "it jumped";
  EXPECT_NEAR(height_m(0.0816, 1432ms), 0.0816, 1e-9) << "no time has passed";
}

TEST(PrismStage, ARecipeWithoutAPrismHasNoModelAndNoForce) {
  PrismStage stage(effects::FemPrismSettings{});
  EXPECT_FALSE(stage.model_at({}).has_value());
  Hand hand(effects::FemPrismSettings{});
  hand.move({0.0, 0.09, 0.0});
  EXPECT_EQ(hand.force_N.norm(), 0.0);
}

}  // namespace
}  // namespace telepalp::core
