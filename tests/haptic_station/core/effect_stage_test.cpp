// An effect whose tissue is computed by a slow stage: registered by one line, driven in virtual time and by threads.

#include "haptic_station/core/effect_stage.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <future>
#include <sstream>
#include <thread>

#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/loop/simulated_rig.h"
#include "haptic_station/loop/tick.h"
#include "haptic_station/station/threads/effect_stage_thread.h"
#include "haptic_station/station/threads/haptic_thread.h"
#include "tests/haptic_station/core/felt_ground.h"
#include "tests/haptic_station/core/steady_now.h"
#include "tests/haptic_station/periods.h"
#include "where.h"

namespace telepalp::core {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

constexpr SessionTime kBegin{10s};

BuiltKinds<KindsWithGround> built(const FeltGroundSettings& settings) {
  const GroundRecipe recipes[] = {effects::SkinSettings{.law = effects::linear_law(100.0)}, settings};
  return build_kinds<KindsWithGround>(recipes);
}

effects::EffectInput pressing(double deep_m) {
  effects::EffectInput in;
  in.device = {{0.0, -deep_m, 0.0}};
  in.contact = {.proxy = {}, .normal = {Vector3d::UnitY()}, .distance_m = -deep_m, .in_body = true, .valid = true};
  return in;
}

/// A hand that rests 20 mm deep over ground that the stage finds, in virtual time.
class Pressing {
 public:
  explicit Pressing(const FeltGroundSettings& settings) : effects_(built(settings)) {
    effects_.bank.begin(pressing(0.02));
  }
  /// `cost`: of each run of the stage.
  void run(Nanoseconds length, Nanoseconds cost) {
    for (const SessionTime end = now_ + length; now_ < end; now_ += loop::kTickPeriod) {
      if (auto result = driver_.finished(now_)) {
        ++handed_over_;
        last_took_ = result->done - begun_;
        stage().hand_over(std::move(*result));
      }
      if (driver_.is_idle()) begun_ = now_;
      driver_.begin(
          now_, stage(), [&](StageStep) { return cost; }, ToolAt{pressing(0.02).device});
      felt_N_ = effects_.bank.step(pressing(0.02), kTick_s).force.N.y();
      most_N_ = std::max(most_N_, felt_N_);
    }
  }
  /// The scene is read again: a new bank and a new stage take the place of the old ones.
  void read_again(const FeltGroundSettings& settings) {
    driver_.drop();
    effects_ = built(settings);
    effects_.bank.begin(pressing(0.02));
  }
  [[nodiscard]] EffectStage& stage() { return *effects_.stages.front(); }
  [[nodiscard]] double felt_N() const { return felt_N_; }
  [[nodiscard]] double most_N() const { return most_N_; }
  [[nodiscard]] int handed_over() const { return handed_over_; }
  [[nodiscard]] Nanoseconds last_took() const { return last_took_; }

 private:
  BuiltKinds<KindsWithGround> effects_;
  VirtualDriver<EffectStage> driver_;
  SessionTime now_ = kBegin;
  SessionTime begun_{};
  Nanoseconds last_took_{};
  double felt_N_ = 0.0;
  double most_N_ = 0.0;
  int handed_over_ = 0;
};

constexpr double kSkin_N = 100.0 * 0.02;

FeltGroundSettings ground_at(double y_m) {
  return {.stiffness_N_per_m = 400.0, .height_at = [y_m](const Vector3d&) { return y_m; }};
}

TEST(OneLine, RegistersAKindThatTheBankStepsBillsAndBuilds) {
  BuiltKinds<KindsWithGround> effects = built(ground_at(-0.01));
  ASSERT_EQ(effects.bank.size(), 2U);
  EXPECT_STREQ(effects.bank.bill()[1].name, "felt_ground");
  ASSERT_EQ(effects.stages.size(), 1U) << "the kind's slow stage is made with it";
  effects.bank.begin(pressing(0.02));
  EXPECT_NEAR(effects.bank.step(pressing(0.02), kTick_s).force.N.y(), kSkin_N, 1e-9) << "no model, no force";
  EXPECT_TRUE(build_effects(std::vector<effects::Recipe>{effects::SkinSettings{}}).stages.empty());
}

/// The name of a kind occurs in the programs' sources only in its own files, its reader, and pictures.
TEST(OneLine, IsAllThatNamesAKindOutsideItsOwnFilesItsReaderAndPictures) {
  const std::filesystem::path root = TELEPALP_SOURCE_DIR "/haptic_station";
  std::string found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string file = std::filesystem::relative(entry.path(), root).string();
    if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
    if (file.starts_with("effects/membrane.") || file == "scenes/read_effects.cpp" ||
        file == "scenes/scene_objects.cpp")
      continue;
    std::ifstream text(entry.path());
    for (std::string line; std::getline(text, line);)
      if (line.find("Membrane") != std::string::npos) found += file + ": " + line + "\n";
  }
  EXPECT_EQ(found, "effects/effect_list.h:     Membrane,                 //\n");
}

/// Whoever makes an effect bank beside the core would not know of the slow stages.
TEST(BuiltEffects, OnlyTheCoreMakesEffects) {
  const std::filesystem::path root = TELEPALP_SOURCE_DIR;
  std::string found;
  for (const char* folder : {"haptic_station", "tools", "clients", "server"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string file = std::filesystem::relative(entry.path(), root).string();
      if ((!file.ends_with(".h") && !file.ends_with(".cpp")) || file.starts_with("haptic_station/effects/") ||
          file.find("node_modules") != std::string::npos)
        continue;
      std::ifstream stream(entry.path());
      std::stringstream text;
      text << stream.rdbuf();
      if (text.str().find("ank.add(") != std::string::npos || text.str().find("ffects.add(") != std::string::npos)
        found += file + "\n";
    }
  EXPECT_EQ(found, "haptic_station/core/built_effects.h\n");
}

TEST(EffectStage, ItsModelIsFeltOnceItIsHandedOver) {
  Pressing hand(ground_at(-0.01));
  hand.run(10ms, 8ms);
  hand.run(1s, 8ms);
  EXPECT_NEAR(hand.felt_N(), kSkin_N + 400.0 * 0.01, 1e-9);
}

TEST(EffectStage, RunsOncePerPeriod) {
  Pressing hand(ground_at(-0.01));
  hand.run(1s, 2ms);
  EXPECT_NEAR(hand.handed_over(), 100, 1);
}

TEST(EffectStage, SlowerThanItsPeriodItRunsBackToBackAndNoBacklogGrows) {
  Pressing hand(ground_at(-0.01));
  hand.run(1s, 35ms);
  EXPECT_NEAR(hand.handed_over(), 28, 1);
  hand.run(100ms, 2ms);
  EXPECT_NEAR(hand.handed_over(), 28 + 10, 2) << "the periods that were left out are not made up for";
  EXPECT_LE(hand.last_took(), 3ms);
}

TEST(EffectStage, ARunThatNeverEndsEndsItsForceAndNothingElse) {
  Pressing hand(ground_at(-0.01));
  hand.run(1s, 2ms);
  ASSERT_GT(hand.felt_N(), kSkin_N + 3.9);
  hand.run(3s, kNever);
  EXPECT_NEAR(hand.felt_N(), kSkin_N, 1e-9) << "the skin is felt, old ground is not";
}

TEST(EffectStage, ARunThatEndsAfterTheSceneWasReadAgainReachesNobody) {
  BuiltKinds<KindsWithGround> old = built(ground_at(0.0));
  const auto job = old.stages.front()->take(kBegin, ToolAt{});
  ASSERT_TRUE(job.has_value());
  auto late = old.stages.front()->run(*job, [](StageStep) { return kBegin + 1s; });
  Pressing hand(ground_at(0.0));
  hand.run(5ms, kNever);
  hand.read_again(ground_at(-0.015));
  old.bank = {};  // the old effects are gone, and their stage ends now
  old.stages.front()->hand_over(std::move(late));
  hand.run(1s, 1ms);
  EXPECT_NEAR(hand.felt_N(), kSkin_N + 400.0 * 0.005, 1e-9) << "the new ground";
  EXPECT_LE(hand.most_N(), kSkin_N + 400.0 * 0.005 + 1e-9) << "never the old one";
}

TEST(EffectStage, BeginsAgainWhenTheSessionClockStepsBack) {
  const BuiltKinds<KindsWithGround> effects = built(ground_at(0.0));
  EXPECT_TRUE(effects.stages.front()->take(kBegin, ToolAt{}).has_value());
  EXPECT_FALSE(effects.stages.front()->take(kBegin + 9ms, ToolAt{}).has_value());
  EXPECT_TRUE(effects.stages.front()->take(kBegin - 5s, ToolAt{}).has_value());
}

/// Steps the bank on this thread until `is_enough`, for at most 10 s.
template <class Bank, class Enough>
bool pressed_until(Bank& bank, LatestValue<ToolAt>& tool, Enough is_enough) {
  for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end;) {
    tool.put({pressing(0.02).device});
    if (is_enough(bank.step(pressing(0.02), kTick_s).force.N.y())) return true;
    std::this_thread::sleep_for(loop::kTickPeriod);
  }
  return false;
}

TEST(EffectStageThread, HandsItsModelsToAnEffectOnAnotherThread) {
  BuiltKinds<KindsWithGround> effects = built(ground_at(-0.01));
  effects.bank.begin(pressing(0.02));
  station::EffectStageThread thread(std::move(effects.stages.front()), steady_now);
  EXPECT_TRUE(pressed_until(effects.bank, thread.tool(), [](double N) { return N > kSkin_N + 3.9; }));
}

TEST(EffectStageThread, EndsWhileARunDoesNotEnd) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::atomic<bool> in_run{false};
  FeltGroundSettings hangs;
  hangs.height_at = [&in_run, ended](const Vector3d&) {
    in_run = true;
    ended.wait();
    return 0.0;
  };
  BuiltKinds<KindsWithGround> old = built(hangs);
  old.bank.begin(pressing(0.02));
  std::atomic<int> asked_after_end{0};
  std::atomic<bool> destroyed{false};
  {
    station::EffectStageThread thread(std::move(old.stages.front()), [&] {
      if (destroyed) ++asked_after_end;
      return steady_now();
    });
    EXPECT_TRUE(pressed_until(old.bank, thread.tool(), [&](double N) { return in_run && N == kSkin_N; }));
  }
  destroyed = true;
  BuiltKinds<KindsWithGround> fresh = built(ground_at(-0.015));  // the scene was read again
  fresh.bank.begin(pressing(0.02));
  station::EffectStageThread thread(std::move(fresh.stages.front()), steady_now);
  end.set_value();  // the old run ends now, and hands over ground at 0
  EXPECT_TRUE(pressed_until(fresh.bank, thread.tool(), [](double N) { return N > kSkin_N + 1.9; }));
  double most_N = 0.0;
  EXPECT_TRUE(pressed_until(fresh.bank, thread.tool(), [&most_N, ticks = 0](double N) mutable {
    most_N = std::max(most_N, N);
    return ++ticks > 300;
  }));
  EXPECT_LE(most_N, kSkin_N + 400.0 * 0.005 + 1e-9) << "the old ground is not felt";
  EXPECT_EQ(asked_after_end, 0) << "the station that owned the clock is gone";
}

TEST(HapticThread, TellsSlowStagesAtEachTickWhereTheToolIs) {
  loop::HapticLoop loop({}, control::EncounteredController({}, {}));
  loop::SimulatedRig rig({.device = {}, .hand = {}, .tracker = {}, .rest = {{0.01, 0.1, 0.02}}},
                         device::ScriptedIntention(device::waypoints(device::Trial::MoveWithin), {}));
  LatestValue<loop::TouchableSurface> surfaces;
  LatestValue<Point<HapticBase>> to_surface;
  auto ticks = std::make_unique<station::TickRing>();
  station::HapticThread haptic(loop, rig, surfaces, *ticks, to_surface);
  LatestValue<ToolAt> told;
  haptic.tell(told);
  haptic.tick({.deadline = station::TickTimer::Clock::time_point(10s), .late = {}, .missed = 0});
  ASSERT_TRUE(told.take());
  ASSERT_TRUE(to_surface.take());
  EXPECT_EQ(told.current().device.m, to_surface.current().m);
  EXPECT_LT((told.current().device.m - Vector3d(0.01, 0.1, 0.02)).norm(), 0.01);
}

}  // namespace
}  // namespace telepalp::core
