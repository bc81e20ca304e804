// Runs of a replay: what a network does to them, and that nothing else does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>

#include "proto/wire/mcap/writer.h"
#include "server/pipeline/camera_messages.h"
#include "support/program/files/shipped.h"
#include "tests/support/child_process.h"
#include "tools/replay/run/session_run.h"
#include "tools/replay/source/session_hand.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

constexpr const char* kSource = "synthetic:torso,motion=irregular";

const scenes::Scene& skin_scene() {
  static const scenes::Scene scene =
      scenes::read_scene(*program::shipped_file("haptic_station/scenes/skin.scene.textproto")).value();
  return scene;
}

/// Everything that a station published, in order.
std::string record(wire::Message message) {
  return std::string(message.topic.name) + std::to_string(to_nanoseconds(message.published)) + *message.payload;
}

struct Ran {
  RunResults results;
  std::string published;  ///< by the last run
};

Ran run(const Scenario& scenario, double seconds, int threads = 2, codec::DepthMode mode = codec::DepthMode::Fast,
        const RecordedHand* recorded = nullptr) {
  Ran ran;
  Result<Tape> tape = Tape::open(kSource, {.depth = {.mode = mode, .key_every = 12}, .color = false});
  EXPECT_TRUE(tape.ok());
  Result<RunResults> results = run_session(
      *tape, {.scene = skin_scene(), .surface = {}, .recorded = recorded, .seconds = seconds, .threads = threads},
      {{.scenario = unimpaired(scenario)},
       {.scenario = scenario, .publish = [&](wire::Message message) { ran.published += record(message); }}});
  EXPECT_TRUE(results.ok()) << (results ? "" : to_string(results.error()));
  ran.results = std::move(*results);
  return ran;
}

Scenario network(Nanoseconds delay, double loss = 0.0) {
  Scenario scenario;
  scenario.down = scenario.up = {.delay = delay, .jitter = delay / 4, .loss = loss, .burst_packets = 4.0};
  scenario.deadline = 100ms + delay;
  return scenario;
}

const Figures& last(const Ran& ran) { return ran.results.runs.back().figures; }

TEST(ReplayCell, GivesTheSameBytesOnOneAndOnSeveralThreads) {
  const Scenario scenario = network(60ms, 0.1);
  const Ran one = run(scenario, 3.0, 1);
  const Ran again = run(scenario, 3.0, 1);
  const Ran several = run(scenario, 3.0, 4);
  ASSERT_GT(one.published.size(), 100'000U);
  EXPECT_TRUE(one.published == again.published);
  EXPECT_TRUE(one.published == several.published);
  EXPECT_EQ(last(one).force_rmse_N, last(several).force_rmse_N);
}

TEST(ReplayCell, GivesOtherBytesWithAnotherSeed) {
  Scenario other = network(60ms, 0.1);
  other.seed = 2;
  EXPECT_FALSE(run(network(60ms, 0.1), 2.0).published == run(other, 2.0).published);
}

TEST(ReplayCell, ARunOverAnUnimpairedNetworkHasNoDifferences) {
  const Ran ran = run(Scenario{}, 4.0);
  EXPECT_EQ(last(ran).force_rmse_N, 0.0);
  EXPECT_EQ(last(ran).phase_differs_pct, 0.0);
  EXPECT_EQ(last(ran).frames_in_time_pct, 100.0);
  EXPECT_EQ(last(ran).datagrams_lost, 0.0);
  EXPECT_EQ(last(ran).frames, 118.0);  // the last two are still within their deadline
}

TEST(ReplayCell, TheHandFeelsTheSkinAndTheDelay) {
  const Ran ran = run(network(150ms), 6.0);
  const Figures& unimpaired = ran.results.runs.front().figures;
  EXPECT_GT(unimpaired.force_max_N, 0.5);
  EXPECT_LT(unimpaired.contact_lost_pct, 5.0);
  EXPECT_LT(unimpaired.surface_error_rms_m, 0.001);
  EXPECT_GT(last(ran).force_rmse_N, 0.0);
  EXPECT_NEAR(last(ran).surface_age_p50_s - unimpaired.surface_age_p50_s, 0.15, 0.04);
  EXPECT_NEAR(last(ran).network_p50_s - unimpaired.network_p50_s, 0.15, 0.04);
}

TEST(ReplayCell, FramesOfALongPathAreStillKnownWhenTheyArrive) {
  const Figures figures = last(run(network(4s), 7.0));
  EXPECT_GT(figures.frames_touched_pct, 0.0) << "the sender sends few frames before the first answer, after 8 s";
}

TEST(ReplayCell, RepairsLossesAndCountsTheBytesOfTheRepairs) {
  const Ran ran = run(network(20ms, 0.05), 4.0);
  EXPECT_GT(last(ran).datagrams_lost, 100.0);
  EXPECT_GT(last(ran).frames_in_time_pct, 90.0);
  EXPECT_GT(last(ran).sent_B, 1.05 * last(ran).content_B);
}

TEST(ReplayCell, LetsGoInALongOutageAndFeelsAgain) {
  Scenario scenario = network(10ms);
  scenario.faults.outages = {{2500ms, 2500ms}};
  const Ran ran = run(scenario, 9.0);
  EXPECT_GT(last(ran).released_pct, 5.0);
  EXPECT_LT(ran.results.runs.front().figures.released_pct, 5.0);
  EXPECT_GT(last(ran).surface_age_p99_s, 1.0);
  EXPECT_GT(last(ran).frames_touched_pct, 50.0);
}

TEST(ReplayCell, AServerThatRestartsIsHeardAgain) {
  Scenario scenario = network(10ms);
  scenario.faults.restarts = {{1s, 500ms}};
  const Figures figures = last(run(scenario, 4.0));
  EXPECT_NEAR(figures.frames, 102.0, 1.0);
  EXPECT_GT(figures.frames_touched_pct, 95.0);
}

TEST(ReplayCell, EachRunGetsTheKeyFramesThatItsOwnLossesRequire) {
  const Figures figures = last(run(network(20ms, 0.1), 4.0, 2, codec::DepthMode::Temporal));
  EXPECT_EQ(figures.frames, 117.0);
  EXPECT_GT(figures.frames_touched_pct, 60.0);
  EXPECT_LT(figures.surface_error_rms_m, 0.001);
}

TEST(ReplayCell, ARecordedHandMovesAsItWasRecorded) {
  RecordedHand hand;
  for (int i = 0; i <= 4000; ++i) {
    const double height_m = 0.08 - 0.09 * i / 4000.0;
    hand.push_back({kBegin + i * kTick, {{0.0, height_m, 0.0}}, {{0.0, height_m, 0.0}}});
  }
  const Ran ran = run(network(30ms), 3.0, 2, codec::DepthMode::Fast, &hand);
  EXPECT_GT(last(ran).force_max_N, 0.05);
  EXPECT_EQ(last(ran).contact_lost_pct, last(ran).contact_lost_pct);  // known: there is a true skin
}

/// A session of the patient with a camera and, if there is one, a station: as a recorder would have written it.
void write_session(const std::filesystem::path& file, double seconds, const std::vector<wire::Message>& station) {
  Result<wire::McapWriter> writer = wire::McapWriter::open(file, {});
  ASSERT_TRUE(writer.ok());
  Result<Tape> tape = Tape::open(kSource, {.color = false});
  const Result<TapeFrames> frames = tape->read_until(kBegin + from_seconds(seconds));
  for (const auto& taped : *frames) {
    const SessionTime captured = taped->frame.captured;
    ASSERT_TRUE(
        writer->write(wire::make_message(wire::kCameraInfo, captured, pipeline::calibration_message(taped->frame)))
            .ok());
    ASSERT_TRUE(
        writer->write({wire::kCameraDepth, captured, std::make_shared<const std::string>(taped->depth), 0, true}).ok());
  }
  for (const wire::Message& message : station) ASSERT_TRUE(writer->write(message).ok());
  ASSERT_TRUE(writer->close().ok());
}

TEST(ReplayCell, ASessionGivesItsFramesAndItsHandAndSoTheSameForces) {
  constexpr double kSeconds = 5.0;
  std::vector<wire::Message> station;
  Result<Tape> live = Tape::open(kSource, {.color = false});
  RunSettings settings{.scene = skin_scene(), .surface = {}, .recorded = nullptr, .seconds = kSeconds, .threads = 2};
  const Result<RunResults> lived =
      run_session(*live, settings,
                  {{.scenario = {}, .publish = [&](wire::Message message) { station.push_back(std::move(message)); }}});
  ASSERT_TRUE(lived.ok());
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "session.mcap";
  write_session(file, kSeconds, station);
  const Result<RecordedHand> hand = read_session_hand(file);
  ASSERT_TRUE(hand.ok());
  ASSERT_EQ(hand->size(), 10'000U);
  EXPECT_EQ(hand->front().at, kBegin);
  Result<Tape> tape = Tape::open(file.string(), {.color = false});
  ASSERT_TRUE(tape.ok());
  settings.recorded = &*hand;
  settings.seconds = 0.0;
  const Result<RunResults> replayed = run_session(*tape, settings, {{.scenario = {}}});
  ASSERT_TRUE(replayed.ok());
  const Figures& then = lived->runs.front().figures;
  const Figures& now = replayed->runs.front().figures;
  EXPECT_GT(then.force_max_N, 0.5);
  EXPECT_NEAR(now.force_max_N, then.force_max_N, 0.05 * then.force_max_N);
  EXPECT_EQ(now.phase_changes, then.phase_changes);
  EXPECT_TRUE(std::isnan(now.true_force_rmse_N));
  write_session(folder.path() / "camera.mcap", 1.0, {});
  EXPECT_TRUE(read_session_hand(folder.path() / "camera.mcap")->empty());
  EXPECT_FALSE(read_session_hand(folder.path() / "none.mcap").ok());
  auto cut = std::find_if(station.begin(), station.end(),
                          [](const wire::Message& message) { return message.topic.name == wire::kStationTicks.name; });
  ASSERT_NE(cut, station.end());
  cut->payload = std::make_shared<const std::string>(cut->payload->substr(0, cut->payload->size() / 2));
  write_session(folder.path() / "cut.mcap", 1.0, {*cut});
  const Result<RecordedHand> damaged = read_session_hand(folder.path() / "cut.mcap");
  ASSERT_FALSE(damaged.ok()) << "a hand with a gap would be replayed without a word";
  EXPECT_NE(damaged.error().what.find("damaged message on /station/ticks"), std::string::npos);
}

TEST(ReplayCell, ASourceWithoutAPatientIsRefused) {
  const Result<Tape> none = Tape::open("openni2", {});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().what.find("not a kind of source"), std::string::npos);
  EXPECT_FALSE(Tape::open("synthetic:torso,motion=dancing", {}).ok());
}

}  // namespace
}  // namespace telepalp::replay
