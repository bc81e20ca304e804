// Storms: the invariants hold in every drawn case, a planted defect is found, and its case becomes short.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tools/replay/storm/storm.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

/// A station that does not let go when its surface is too old: it keeps the last force.
Spoil keeps_pushing() {
  return [last = Eigen::Vector3f(Eigen::Vector3f::Zero())](TickRecord& tick) mutable {
    if (tick.surface_age_s > 1.0F && std::isfinite(tick.surface_age_s)) {
      tick.force_N = last;
      tick.phase = control::Phase::InBody;
    }
    last = tick.force_N;
  };
}

StormCase with_outage() {
  StormCase storm{.motion = "speech", .patient_seed = 7, .scene = "palpation", .scenario = {}, .seconds = 6.0};
  storm.scenario.down = storm.scenario.up = {.delay = 120ms, .jitter = 20ms, .loss = 0.1, .burst_packets = 4.0};
  storm.scenario.deadline = 220ms;
  storm.scenario.faults = {.outages = {{1s, 3s}}, .tracker_lost = {{500ms, 300ms}}, .glitches = {{{800ms, 3ms}, 0.02}}};
  storm.scenario.seed = 5;
  return storm;
}

TEST(ReplayStorm, APlantedDefectIsFoundAndItsCaseIsShrunk) {
  const auto holds = run_case(with_outage());
  ASSERT_TRUE(holds.ok()) << to_string(holds.error());
  ASSERT_FALSE(holds->violation) << in_words(*holds->violation);
  const auto planted = run_case(with_outage(), keeps_pushing());
  ASSERT_TRUE(planted->violation);
  EXPECT_NE(planted->violation->what.find("still gives force"), std::string::npos) << planted->violation->what;
  const auto simplest = shrunk(with_outage(), keeps_pushing());
  ASSERT_TRUE(simplest.ok());
  const std::string line = command_line(*simplest);
  EXPECT_NE(line.find("--outage 1000ms+3000ms"), std::string::npos) << line;
  for (const char* gone : {"--tracker-lost", "--glitch", "--loss", "--jitter-ms", "speech", "palpation"})
    EXPECT_EQ(line.find(gone), std::string::npos) << line;
}

TEST(ReplayStorm, EveryInvariantCanFail) {
  const auto fails_with = [](const std::vector<TickRecord>& ticks, const char* what) {
    Invariants invariants({}, {}, 500.0);
    for (const TickRecord& tick : ticks) invariants.add(tick);
    ASSERT_TRUE(invariants.violation()) << what;
    EXPECT_NE(invariants.violation()->what.find(what), std::string::npos) << invariants.violation()->what;
  };
  const auto pushing = [](float force_N) { return TickRecord{.force_N = {0.0F, force_N, 0.0F}}; };
  fails_with({pushing(std::numeric_limits<float>::quiet_NaN())}, "not finite");
  fails_with({pushing(0.0F), pushing(0.12F)}, "more than its motion explains");
  std::vector<TickRecord> steps(30, {.phase = control::Phase::InBody});
  steps.back().force_N.y() = 0.06F;
  fails_with(steps, "more than its motion explains");
  std::vector<TickRecord> rising;
  for (int i = 0; i <= 120; ++i) rising.push_back(pushing(0.09F * static_cast<float>(i)));
  fails_with(rising, "above the scene's limits.peak_N");
  fails_with({{.passivity_J = -0.006F}}, "the display created energy");
  fails_with({{.hand_excess_J = 0.26F}}, "the excess work on the hand is too large");
  std::vector<TickRecord> lifted;  // by 25 mm with 1 N, over a measured skin that gives nothing
  for (int i = 0; i <= 100; ++i)
    lifted.push_back({.force_N = {0.0F, 1.0F, 0.0F},
                      .device_m = {0.0, 0.00025 * i, 0.0},
                      .touching = true,
                      .hand_excess_J = 0.00025F * static_cast<float>(i)});
  lifted.front().force_N.y() = 0.05F;
  fails_with(lifted, "the device gave the hand");
  fails_with(std::vector<TickRecord>(1002, {.phase = control::Phase::InBody, .surface_age_s = 2.6F}),
             "still gives force");
  fails_with(std::vector<TickRecord>(9100, {.depth_m = 0.006F, .surface_age_s = 0.1F}), "but there is no force");
  fails_with(std::vector<TickRecord>(9100, {.phase = control::Phase::Released, .depth_m = 0.2F, .surface_age_s = 0.1F}),
             "but there is no force");
}

TEST(ReplayStorm, ADeviceBelowTheReachOfContactsIsLifted) {
  const auto lifted_at = [](float depth_m) {
    Invariants invariants({}, {}, 500.0);
    for (int i = 0; i < 9100; ++i)
      invariants.add(TickRecord{.phase = control::Phase::BodyToPlane, .depth_m = depth_m, .surface_age_s = 0.1F});
    return !invariants.violation();
  };
  EXPECT_TRUE(lifted_at(0.12F));
  EXPECT_FALSE(lifted_at(0.08F)) << "here the contact begins";
}

TEST(ReplayStorm, TheTimeUnderHalfTheLawIsThatOfYoungImages) {
  Invariants invariants({}, {}, 500.0);
  TickRecord weak{.phase = control::Phase::InBody, .felt = true, .law_N = 1.0F, .surface_age_s = 0.1F};
  weak.off_truth_N = -0.6F;
  for (int i = 0; i < 400; ++i) invariants.add(weak);
  weak.surface_age_s = 0.6F;
  for (int i = 0; i < 400; ++i) invariants.add(weak);
  EXPECT_NEAR(invariants.ledgers().longest_weak_s, 0.2, 1e-9);
}

TEST(ReplayStorm, AStepThatTheMotionExplainsAndTheStepsOfANewContactAreAllowed) {
  Invariants invariants({}, {}, 500.0);
  for (int i = 0; i < 100; ++i)  // 1 m/s on 500 N/m
    invariants.add(TickRecord{.force_N = {0.0F, 0.25F * static_cast<float>(i % 30), 0.0F},
                              .device_m = {0.0, 0.0005 * (i % 30), 0.0},
                              .phase = control::Phase::InBody});
  EXPECT_FALSE(invariants.violation()) << in_words(*invariants.violation());
  for (int i = 0; i < 15; ++i)
    invariants.add(TickRecord{.force_N = {0.0F, 2.25F - 0.9F * static_cast<float>(i % 2), 0.0F},
                              .device_m = {0.0, 0.0005 * 9, 0.0},
                              .phase = control::Phase::BodyToPlane});
  EXPECT_FALSE(invariants.violation()) << in_words(*invariants.violation());
}

TEST(ReplayStorm, ASilentOrDisorderedTopicIsSeen) {
  Invariants invariants({}, {}, 500.0);
  invariants.add(
      wire::Message{.topic = wire::kStationState, .published = kBegin + 10ms, .payload = {}, .key_frame = true});
  EXPECT_FALSE(invariants.violation());
  invariants.add(wire::Message{.topic = wire::kStationEvents, .published = kBegin, .payload = {}, .key_frame = true});
  EXPECT_FALSE(invariants.violation());
  invariants.add(wire::Message{.topic = wire::kStationState, .published = kBegin, .payload = {}, .key_frame = true});
  EXPECT_TRUE(invariants.violation());
}

TEST(ReplayStorm, ACaseIsRepeatedByItsSeed) {
  for (std::uint64_t seed = 1; seed < 50; ++seed)
    EXPECT_EQ(command_line(draw_case(seed)), command_line(draw_case(seed)));
  EXPECT_NE(command_line(draw_case(1)), command_line(draw_case(2)));
}

}  // namespace
}  // namespace telepalp::replay
