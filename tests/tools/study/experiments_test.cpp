#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>

#include "tests/support/child_process.h"
#include "tools/study/experiments/obstruction.h"
#include "tools/study/experiments/ribs.h"
#include "tools/study/experiments/stiffness.h"
#include "tools/study/page/experiment_page.h"
#include "where.h"

namespace telepalp::study {
namespace {

namespace fs = std::filesystem;

/// Share of right answers of many trials.
double right_share(const StiffnessObserver& person, Sight sight, double difference) {
  device::Random random(7);
  constexpr int kTrials = 20'000;
  int right = 0;
  for (int i = 0; i < kTrials; ++i) right += answers_right(person, sight, difference, 1.0, random) ? 1 : 0;
  return static_cast<double>(right) / kTrials;
}

/// Only the seen displacement is noisy, by a share of it.
StiffnessObserver by_sight_alone() {
  return {.push_spread = 0.0,
          .force_noise = 0.0,
          .touch_noise = 0.0,
          .sight_noise = 0.1,
          .sight_floor_m = 0.0,
          .sight_weight = 1.0,
          .hand_weight = 0.1,
          .practice = 0.0,
          .lapses = 0.0};
}

TEST(Stiffness, AnObserverBySightAnswersAsTheClosedFormSays) {
  // The logarithms of both seen displacements differ by log(1.15), with noise of 0.1 sqrt(2).
  const double z = std::log(1.15) / (0.1 * std::sqrt(2.0));
  const double expected = 0.5 * std::erfc(-z / std::sqrt(2.0));
  EXPECT_NEAR(right_share(by_sight_alone(), Sight::Corrected, 0.15), expected, 0.01);
  // A hand that sinks by F / 200 N/m besides dilutes the difference: of F / K + 0.1 F / 200 only the first part
  // shrinks.
  const auto seen = [](double prism) { return 1.0 / prism + 0.1 / kCoupling_N_per_m; };
  const double diluted = std::log(seen(kPrism_N_per_m) / seen(1.15 * kPrism_N_per_m)) / (0.1 * std::sqrt(2.0));
  EXPECT_NEAR(right_share(by_sight_alone(), Sight::Naive, 0.15), 0.5 * std::erfc(-diluted / std::sqrt(2.0)), 0.01);
}

TEST(Stiffness, TheHandAloneHardlyFeelsADifferenceBehindTheCoupling) {
  EXPECT_LT(right_share({}, Sight::None, 0.4), 0.58) << "3.7 % against a noise of 20 %";
  StiffnessObserver exact;
  exact.touch_noise = 0.01;
  exact.lapses = 0.0;
  EXPECT_GT(right_share(exact, Sight::None, 0.4), 0.97) << "a hand without noise does";
}

TEST(Stiffness, WithoutTheAssumedWeightOfTheHandBothConditionsAreAlike) {
  StiffnessObserver person;
  person.hand_weight = 0.0;
  EXPECT_EQ(right_share(person, Sight::Naive, 0.3), right_share(person, Sight::Corrected, 0.3));
}

TEST(Orders, EachIsEquallyFrequentAndDependsOnTheSeed) {
  std::map<std::vector<std::size_t>, int> seen;
  for (std::size_t i = 0; i < 60; ++i) ++seen[order_of(1, i, 3)];
  ASSERT_EQ(seen.size(), 6U);
  for (const auto& [order, count] : seen) EXPECT_EQ(count, 10);
  int alike = 0;
  for (std::size_t i = 0; i < 60; ++i) alike += order_of(1, i, 3) == order_of(2, i, 3) ? 1 : 0;
  EXPECT_LT(alike, 30);
}

/// The shortest way from pocket to pocket that stays `clear_m` away from the device's middle [m].
double shortest_way_m(const PushDesk& desk, double clear_m) noexcept {
  const double half_m = 0.5 * desk.pockets_m;
  const double away_m = std::hypot(half_m, desk.beside_m);
  if (clear_m <= desk.beside_m) return desk.pockets_m;
  if (clear_m >= away_m) return std::numbers::pi * clear_m;
  const double to_foot = std::atan2(half_m, desk.beside_m);  // from the middle: angle of a pocket to the nearest point
  const double tangent = std::acos(clear_m / away_m);
  return 2.0 * (std::sqrt(away_m * away_m - clear_m * clear_m) + clear_m * std::max(0.0, to_foot - tangent));
}

TEST(PushTask, TheStraightWayIsTakenUnlessADeviceInSightIsInIt) {
  const PushDesk desk;
  Pusher steady;
  steady.unsteady = 0.0;
  steady.heeds = 1.0;
  device::Random random(1);
  const auto path_m = [&](bool sees_device) {
    Pushed at{.ball_m = {desk.pockets_m, 0.0}, .stick_m = {desk.pockets_m + 0.017, 0.0}};
    const Push push = push_ball(steady, desk, false, 9, sees_device, at, random);
    EXPECT_TRUE(push.done);
    return push.path_m;
  };
  const double straight_m = path_m(false), around_m = path_m(true);
  EXPECT_NEAR(straight_m, desk.pockets_m - desk.pocket_m, 0.02);
  const double least = shortest_way_m(desk, desk.body_m + steady.clearance_m) - desk.pockets_m;
  EXPECT_GT(around_m - straight_m, 0.5 * least);
  EXPECT_LT(around_m, 3.0 * straight_m) << "a curved way is hard to push along, but not this hard";
}

TEST(PushTask, TheShortestWayGrowsWithTheClearanceAndIsNeverShorterThanTheStraightOne) {
  const PushDesk desk;
  double before = 0.0;
  for (double clear_m = 0.0; clear_m < 0.12; clear_m += 0.001) {
    const double way_m = shortest_way_m(desk, clear_m);
    EXPECT_GE(way_m, desk.pockets_m);
    EXPECT_GE(way_m, before - 1e-9);
    before = way_m;
  }
  EXPECT_NEAR(shortest_way_m({.pockets_m = 0.2, .beside_m = 0.0}, 0.1 / std::sqrt(2.0)),
              0.2 / std::sqrt(2.0) + 0.1 / std::sqrt(2.0) * 1.5707963, 1e-6);
}

const Chest& chest() {
  static const Result<Chest> read = read_chest("ribs-ultrasound");
  EXPECT_TRUE(read.ok());
  return *read;
}

TEST(Ribs, ASlideAlongTheSceneFeelsItsTwelveRibs) {
  ASSERT_EQ(chest().ribs_m.size(), 12U);
  for (std::size_t i = 1; i < 12; ++i) EXPECT_NEAR(chest().ribs_m[i] - chest().ribs_m[i - 1], 0.031, 0.005) << i;
}

TEST(Ribs, AFirmPressSinksBetweenThemAndAnExactObserverCountsThemAll) {
  device::Random random(1);
  const auto samples =
      slide(chest(), 0.9, 0.04, chest().ribs_m.front() - 0.015, chest().ribs_m.back() + 0.015, 0.0, random);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end(),
                                               [](const auto& a, const auto& b) { return a.height_m < b.height_m; });
  EXPECT_GT(high->height_m - low->height_m, 0.003);
  RibCounter exact{.force_jnd = 0.0, .force_floor_N = 0.01, .height_m = 1e-4, .sight_m = 1e-4, .lapses = 0.0};
  EXPECT_EQ(counted_ribs(exact, samples, 0.9, false, random), 12);
  EXPECT_EQ(counted_ribs(exact, samples, 0.9, true, random), 12);
  RibCounter numb = exact;
  numb.force_floor_N = 50.0;
  numb.height_m = 1.0;
  numb.caution = 12.0;
  EXPECT_EQ(counted_ribs(numb, samples, 0.9, false, random), 0);
}

ExperimentSettings settings_in(const fs::path& out, int observers, int threads = 1) {
  return {.observers = observers, .seed = 1, .threads = threads, .out = out};
}

std::string csv(const Experiment& experiment, const ExperimentSettings& settings) {
  const Result<std::vector<Row>> rows = run_experiment(experiment, settings, [](int) {});
  EXPECT_TRUE(rows.ok());
  return rows_csv(experiment, settings, *rows);
}

TEST(Experiments, GiveTheSameBytesTwiceWithAnyNumberOfThreadsAndWhenTheyAreResumed) {
  for (const Experiment& experiment : {obstruction_experiment(), stiffness_experiment(ThresholdRule::Staircase)}) {
    const support::TemporaryFolder folder;
    const std::string first = csv(experiment, settings_in(folder.path(), 6));
    EXPECT_EQ(kept_parts(parts_of(experiment, settings_in(folder.path(), 6))), 6);
    fs::remove(folder.path() / "runs" / "observer-00002.csv");
    std::ofstream(folder.path() / "runs" / "observer-00004.csv", std::ios::trunc) << "# cut off";
    EXPECT_EQ(kept_parts(parts_of(experiment, settings_in(folder.path(), 6))), 4);
    EXPECT_EQ(csv(experiment, settings_in(folder.path(), 6)), first);
    fs::remove_all(folder.path() / "runs");
    EXPECT_EQ(csv(experiment, settings_in(folder.path(), 6, 2)), first);
    ExperimentSettings other = settings_in(folder.path(), 6);
    other.seed = 2;
    EXPECT_EQ(kept_parts(parts_of(experiment, other)), 0);
  }
  const support::TemporaryFolder folder;
  (void)csv(stiffness_experiment(ThresholdRule::Staircase), settings_in(folder.path(), 4));
  EXPECT_EQ(kept_parts(parts_of(stiffness_experiment(ThresholdRule::Quest), settings_in(folder.path(), 4))), 0);
}

TEST(Experiments, PageAndNumbersAreMadeAndNothingIsNotANumber) {
  for (const Experiment& experiment :
       {obstruction_experiment(), stiffness_experiment(ThresholdRule::Quest), rib_experiment(chest())}) {
    const support::TemporaryFolder folder;
    const ExperimentSettings settings = settings_in(folder.path(), 6);
    const Result<std::vector<Row>> rows = run_experiment(experiment, settings, [](int) {});
    ASSERT_TRUE(rows.ok());
    const Result<ExperimentResult> result = result_of(experiment, *rows);
    ASSERT_TRUE(result.ok());
    for (const std::string& text :
         {experiment_html(experiment, settings, *result), experiment_text(experiment, *result),
          experiment_json(experiment, settings, *result)}) {
      EXPECT_EQ(text.find("nan"), std::string::npos) << experiment.name;
      EXPECT_NE(text.find(result->compared.front().measure.name), std::string::npos);
    }
    EXPECT_EQ(result->compared.front().test.degrees == 5.0, experiment.subjects == Subjects::Within);
  }
}

TEST(Experiments, TheCommandsRunAndRefuseWhatTheyCannotDo) {
  const support::TemporaryFolder folder;
  const fs::path log = folder.path() / "log";
  const auto run = [&](std::vector<std::string> arguments) {
    support::ChildProcess child(fs::path(TELEPALP_BINARY_DIR) / "bin" / "telepalp-study", arguments, log);
    return child.wait(std::chrono::seconds(60)).value_or(-1);
  };
  const auto heard = [&] {
    std::ifstream in(log);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  ASSERT_EQ(run({"obstruction", "--observers", "8", "--out", (folder.path() / "o").string()}), 0) << heard();
  EXPECT_NE(heard().find("time, green to blue: the difference in sight minus hidden is"), std::string::npos) << heard();
  for (const char* file : {"report.html", "study.json", "trials.csv", "runs/observer-00008.csv"})
    EXPECT_TRUE(fs::exists(folder.path() / "o" / file)) << file;
  EXPECT_EQ(run({"stiffness-jnd", "--rule", "guess", "--out", (folder.path() / "s").string()}), 2);
  EXPECT_NE(heard().find("--rule: 'guess' is not a rule. fix: give staircase or quest"), std::string::npos) << heard();
  EXPECT_EQ(run({"stiffness-jnd", "--observers", "2"}), 2);
  EXPECT_FALSE(fs::exists(folder.path() / "s"));
}

}  // namespace
}  // namespace telepalp::study
