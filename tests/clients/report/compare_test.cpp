// telepalp-report of two sessions: what differs, first where, and why.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "clients/report/compare/cause.h"
#include "clients/report/compare/comparison_html.h"
#include "proto/wire/mcap/writer.h"
#include "tests/clients/report/change_each.h"
#include "tests/clients/report/made_session.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::report {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// From 1 s on, in the first contact, the device gives no force.
void lose_force(std::vector<wire::Message>& messages) {
  change_each<msg::StationTicks>(messages, wire::kStationTicks, [](msg::StationTicks& batch) {
    if (static_cast<std::int64_t>(batch.first_tick_ns()) < kMadeStart_ns + kSecond_ns) return;
    for (auto* axis : {batch.mutable_force_x(), batch.mutable_force_y(), batch.mutable_force_z()})
      std::fill(axis->begin(), axis->end(), 0.0F);
  });
}

/// The surface is 100 ms older at each state.
void age_surface(std::vector<wire::Message>& messages) {
  change_each<msg::StationState>(messages, wire::kStationState, [](msg::StationState& state) {
    if (state.surface_captured_ns() > 0) state.set_surface_captured_ns(state.surface_captured_ns() - 100'000'000);
  });
}

void move_hand(std::vector<wire::Message>& messages) {
  change_each<msg::StationTicks>(messages, wire::kStationTicks, [](msg::StationTicks& batch) {
    for (float& x : *batch.mutable_hand_x()) x += 0.012F;
  });
}

class Compare : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::vector<wire::Message>& messages,
                              const wire::SessionInfo& info = kInfo) {
    const std::filesystem::path file = folder_.path() / name;
    Result<wire::McapWriter> writer = wire::McapWriter::open(file, info);
    EXPECT_TRUE(writer);
    for (const wire::Message& message : messages) EXPECT_TRUE(writer->write(message));
    EXPECT_TRUE(writer->close());
    return file;
  }

  Comparison compared(const std::vector<wire::Message>& other) {
    Result<Comparison> result = compare(write("a.mcap", made_), write("b.mcap", other));
    EXPECT_TRUE(result);
    return std::move(result).value();
  }

  static inline const wire::SessionInfo kInfo{
      .program = "telepalp-record", .version = "1", .commit = "c0", .source = "made", .scene = "name: \"skin\"\n"};
  support::TemporaryFolder folder_;
  const std::vector<wire::Message> made_ = made_messages({.seconds = 2.0});
};

TEST_F(Compare, EqualSessionsAreCalledEqualMessageByMessage) {
  const Comparison comparison = compared(made_);
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(headline(comparison), "The two runs are equal, message by message.");
  EXPECT_FALSE(comparison.ticks.first_felt || comparison.ticks.first_phase || comparison.ticks.largest);
  EXPECT_EQ(comparison.ticks.common, 4000u);
  for (const MetricPair& pair : comparison.metrics) EXPECT_FALSE(pair.worse()) << pair.name;
}

TEST_F(Compare, AForceThatIsLostInContactIsTheFirstDifferenceAndTheAgeOfTheSurfaceItsCause) {
  std::vector<wire::Message> other = made_;
  lose_force(other);
  age_surface(other);
  const Comparison comparison = compared(other);
  ASSERT_TRUE(comparison.ticks.first_felt);
  EXPECT_NEAR(comparison.ticks.first_felt->at_s, 1.0, 1e-9);
  EXPECT_FALSE(comparison.ticks.first_phase) << "the states are equal";
  EXPECT_NE(headline(comparison).find("difference 1 s after the start:"), std::string::npos) << headline(comparison);
  EXPECT_NE(headline(comparison).find("0 N in B"), std::string::npos) << headline(comparison);
  EXPECT_NE(account(comparison).find("ms old in A and"), std::string::npos) << account(comparison);
  ASSERT_TRUE(comparison.first_message);
  EXPECT_NE(comparison.first_message->find("surface_captured_ns"), std::string::npos) << *comparison.first_message;
  const auto age = std::find_if(comparison.metrics.begin(), comparison.metrics.end(),
                                [](const MetricPair& pair) { return pair.name == "age of the touched surface, p50"; });
  ASSERT_NE(age, comparison.metrics.end());
  EXPECT_NEAR(age->b - age->a, 100.0, 1.0);
  EXPECT_TRUE(age->worse());
}

TEST_F(Compare, AForceThatMovesTheFreeDeviceIsNotFelt) {
  std::vector<wire::Message> other = made_;
  change_each<msg::StationTicks>(other, wire::kStationTicks, [](msg::StationTicks& batch) {
    if (batch.phase(0) == msg::PHASE_OUT_BODY && batch.phase(batch.phase_size() - 1) == msg::PHASE_OUT_BODY)
      std::fill(batch.mutable_force_y()->begin(), batch.mutable_force_y()->end(), 1.0F);
  });
  const Comparison comparison = compared(other);
  EXPECT_FALSE(comparison.ticks.first_felt);
  ASSERT_TRUE(comparison.ticks.largest);
  EXPECT_NEAR(comparison.ticks.largest->force_apart_N, 1.0, 1e-6);
  EXPECT_NE(headline(comparison).find("feels no difference"), std::string::npos) << headline(comparison);
}

TEST_F(Compare, HandsThatMovedDifferentlyAreNamedBeforeAnyOtherCause) {
  std::vector<wire::Message> other = made_;
  lose_force(other);
  age_surface(other);
  move_hand(other);
  const Comparison comparison = compared(other);
  ASSERT_TRUE(comparison.ticks.first_felt);
  EXPECT_NE(account(comparison).find("hands of A and B are 12 mm apart"), std::string::npos) << account(comparison);
}

TEST_F(Compare, AStationThatLetGoIsTheCauseAndItsLastEventIsQuoted) {
  std::vector<wire::Message> other = made_;
  lose_force(other);
  change_each<msg::StationTicks>(other, wire::kStationTicks, [](msg::StationTicks& batch) {
    if (static_cast<std::int64_t>(batch.first_tick_ns()) < kMadeStart_ns + kSecond_ns) return;
    std::fill(batch.mutable_phase()->begin(), batch.mutable_phase()->end(), msg::PHASE_RELEASED);
  });
  msg::StationEvent event;
  event.set_stamp_ns(static_cast<std::uint64_t>(kMadeStart_ns + kSecond_ns - 1'000'000));
  event.set_kind(msg::EVENT_KIND_LINK);
  event.set_text("the server is away");
  other.push_back(wire::make_message(wire::kStationEvents, session_time(kMadeStart_ns + kSecond_ns), event));
  const Comparison comparison = compared(other);
  ASSERT_TRUE(comparison.ticks.first_phase);
  EXPECT_EQ(cause_in_words(comparison.a, comparison.b, *comparison.ticks.first_phase),
            "B gives the hand no force (state: Force paused); its last event: the server is away");
}

TEST_F(Compare, SessionsOfDifferentDaysAreAlignedAtTheirFirstTicks) {
  std::vector<wire::Message> other = made_;
  for (wire::Message& message : other) message.published += std::chrono::hours(24);
  change_each<msg::StationTicks>(other, wire::kStationTicks, [](msg::StationTicks& batch) {
    batch.set_first_tick_ns(batch.first_tick_ns() + 24ULL * 3600 * kSecond_ns);
  });
  lose_force(other);
  const Comparison comparison = compared(other);
  EXPECT_FALSE(comparison.messages_compared);
  EXPECT_FALSE(comparison.equal());
  EXPECT_EQ(comparison.ticks.common, 4000u);
}

TEST_F(Compare, ASessionWithoutAStationIsComparedByItsFiguresAlone) {
  const Comparison comparison = compared(made_messages({.seconds = 1.0, .with_station = false}));
  EXPECT_EQ(comparison.ticks.common, 0u);
  EXPECT_NE(headline(comparison).find("only their summary figures"), std::string::npos);
  EXPECT_FALSE(comparison_html(comparison, {}).empty());
}

TEST_F(Compare, SettingsThatDifferComeFirstWithTheFirstLineOfTheSceneThatDoes) {
  wire::SessionInfo changed = kInfo;
  changed.version = "2";
  changed.scene = "name: \"skin\"\nstiffness: 300\n";
  Result<Comparison> comparison = compare(write("a.mcap", made_), write("b.mcap", made_, changed));
  ASSERT_TRUE(comparison);
  ASSERT_GE(comparison->settings.size(), 3u);
  EXPECT_EQ(comparison->settings[0].name, "software");
  EXPECT_EQ(comparison->settings[1].name, "scene");
  EXPECT_EQ(comparison->settings[1].b, "skin; A lacks line 2 of B: stiffness: 300");
  EXPECT_FALSE(comparison->settings[2].differs());
  EXPECT_TRUE(comparison->equal()) << "metadata are no messages";
}

TEST(ReplayFacts, AreReadFromTheReportBesideTheSession) {
  const std::string json = R"({"program": "telepalp-replay", "network": "80 ms one way; seed 3", "seed": 3,
    "hand": "examine", "unimpaired": {"force_rmse_N": 0}, "run": {"force_rmse_N": 0.25, "true_force_rmse_N": null}})";
  const auto run = replay_facts(json, false), unimpaired = replay_facts(json, true);
  ASSERT_TRUE(run && unimpaired);
  EXPECT_EQ(run->network, "80 ms one way; seed 3");
  EXPECT_EQ(run->seed, "3");
  EXPECT_EQ(run->figures, (std::map<std::string, double>{{"force_rmse_N", 0.25}}));
  EXPECT_EQ(unimpaired->network, "unimpaired (no delay, loss or fault)");
  EXPECT_EQ(unimpaired->figures.at("force_rmse_N"), 0.0);
  EXPECT_FALSE(replay_facts("{", false));
  EXPECT_FALSE(replay_facts(R"({"program": "telepalp-report"})", false));
}

TEST_F(Compare, WordsFromASessionCannotBreakThePageAndThePageNeedsNoOtherFile) {
  wire::SessionInfo changed = kInfo;
  changed.recorded_by = "<script>alert(1)</script>";
  Result<Comparison> comparison = compare(write("a.mcap", made_), write("b.mcap", made_, changed));
  ASSERT_TRUE(comparison);
  const std::string page = comparison_html(*comparison, {"png a", ""});
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("&lt;script"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_NE(page.find("B: the session holds no depth image that can be decoded"), std::string::npos);
}

TEST_F(Compare, TheProgramWritesOnePageWithBothPicturesForTheGroupAlone) {
  std::vector<wire::Message> other = made_;
  lose_force(other);
  const auto a = write("a.mcap", made_), b = write("b.mcap", other), out = folder_.path() / "out";
  support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-report", {a, b, "--out", out});
  ASSERT_EQ(program.wait(std::chrono::seconds(60)), 0);
  EXPECT_EQ(std::filesystem::status(out / "comparison.html").permissions(), std::filesystem::perms{0640});
  std::stringstream page;
  page << std::ifstream(out / "comparison.html").rdbuf();
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.str().find("data:image/png;base64,", at)) != std::string::npos; ++at) ++pictures;
  EXPECT_EQ(pictures, 2u);
  support::ChildProcess three(TELEPALP_BINARY_DIR "/bin/telepalp-report", {a, b, a, "--out", out});
  EXPECT_EQ(three.wait(std::chrono::seconds(60)), 2);
}

}  // namespace
}  // namespace telepalp::report
