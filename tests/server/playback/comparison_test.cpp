// Two runs on one time axis: how they are aligned, what a bin keeps, and which difference is the first that is felt.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "server/playback/comparison/compare_tracks.h"
#include "server/playback/comparison/session_comparison.h"
#include "tests/proto/mcap_samples.h"

namespace telepalp::playback {
namespace {

using wire::samples::kStart_ns;

constexpr std::int64_t kStep_ns = 10'000'000;
constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// A run of 20 s from `begin_ns` on: in contact from the 5th to the 15th second, with 2 N along y.
StateTrack run(std::int64_t begin_ns) {
  StateTrack track{.begin_ns = begin_ns, .end_ns = begin_ns + 2000 * kStep_ns, .points = {}};
  for (int i = 0; i < 2000; ++i) {
    const bool contact = i >= 500 && i < 1500;
    track.points.push_back({.at_ns = begin_ns + i * kStep_ns,
                            .force_N = {0.0F, contact ? 2.0F : 0.5F, 0.0F},
                            .indentation_m = contact ? 0.02F : 0.0F,
                            .phase = contact ? msg::PHASE_IN_BODY : msg::PHASE_OUT_BODY});
  }
  return track;
}

TEST(CompareTracks, EqualRunsHaveNoDifference) {
  const msg::ComparisonState state = compare_tracks(run(kStart_ns), run(kStart_ns));
  EXPECT_TRUE(state.same_time());
  EXPECT_FALSE(state.has_first());
  EXPECT_EQ(state.apart_n_size(), kComparisonBins);
  EXPECT_EQ(*std::ranges::max_element(state.apart_n()), 0.0F);
}

TEST(CompareTracks, TheFirstDifferenceInContactIsFoundAndOneOutOfContactIsNot) {
  StateTrack other = run(kStart_ns);
  other.points[100].force_N[1] = 3.0F;   // the device moves: no hand feels it
  other.points[700].force_N[0] = 0.04F;  // below what a hand notices
  other.points[900].force_N[0] = 0.3F;   // as long as before, but in another direction
  const msg::ComparisonState state = compare_tracks(run(kStart_ns), other);
  ASSERT_TRUE(state.has_first());
  EXPECT_NEAR(state.first().at_s(), 9.0, 1e-6);
  EXPECT_NEAR(state.first().apart_n(), 0.3, 1e-6);
  EXPECT_NEAR(state.first().force_a_n(), 2.0, 1e-6);
}

TEST(CompareTracks, RunsOfOtherTimesAreComparedFromTheirFirstStatesOn) {
  StateTrack other = run(kStart_ns + kHour_ns);
  other.points[900].force_N[1] = 2.5F;
  const msg::ComparisonState state = compare_tracks(run(kStart_ns), other);
  EXPECT_FALSE(state.same_time());
  ASSERT_TRUE(state.has_first());
  EXPECT_NEAR(state.first().at_s(), 9.0, 1e-6);
  EXPECT_NEAR(state.first().force_b_n(), 2.5, 1e-6);
}

TEST(CompareTracks, ABinKeepsThePeakOfItsTime) {
  StateTrack a = run(kStart_ns);
  a.points[1001].force_N[1] = 7.0F;
  const msg::ComparisonState state = compare_tracks(a, run(kStart_ns));
  EXPECT_EQ(*std::ranges::max_element(state.a().force_n()), 7.0F);
  const auto peak = std::ranges::max_element(state.a().force_n()) - state.a().force_n().begin();
  EXPECT_NEAR(state.begin_s() + (static_cast<double>(peak) + 0.5) * state.bin_s(), 10.01, state.bin_s());
  EXPECT_EQ(state.a().phase(static_cast<int>(peak)), msg::PHASE_IN_BODY);
}

TEST(CompareTracks, TheDrivesForceIsNotShownAsContact) {
  StateTrack a = run(kStart_ns);
  a.points[100].force_N[1] = 3.0F;
  const msg::ComparisonState state = compare_tracks(a, run(kStart_ns));
  EXPECT_EQ(*std::ranges::max_element(state.a().force_n()), 2.0F);
  EXPECT_EQ(state.a().force_n(0), 0.0F) << "0.5 N of the drive";
}

TEST(CompareTracks, ARunThatEndsEarlyIsZeroAfterwardsAndIsNotComparedThere) {
  StateTrack shorter = run(kStart_ns);
  shorter.points.resize(1000);
  const msg::ComparisonState state = compare_tracks(run(kStart_ns), shorter);
  EXPECT_FALSE(state.has_first());
  EXPECT_EQ(state.b().phase(700), msg::PHASE_UNSPECIFIED);
  EXPECT_EQ(state.b().force_n(700), 0.0F);
  EXPECT_GT(state.a().force_n(700), 1.0F);
}

/// A session file whose station presses with `force_N` for a second.
void write_session(const std::filesystem::path& file, double force_N, bool with_station) {
  std::vector<wire::Message> messages;
  for (int i = 0; i < 100; ++i) {
    const SessionTime at = session_time(kStart_ns + i * kStep_ns);
    msg::StationState state;
    state.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(at)));
    state.mutable_force_n()->set_y(force_N);
    state.set_indentation_m(0.01);
    state.set_phase(msg::PHASE_IN_BODY);
    messages.push_back(with_station ? wire::make_message(wire::kStationState, at, state)
                                    : wire::make_message(wire::kServerStats, at, msg::ServerStats()));
  }
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
}

class Comparison : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("telepalp_comparison_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    write_session(folder_ / "played.mcap", 2.0, true);
    write_session(folder_ / "other.mcap", 2.5, true);
    write_session(folder_ / "camera.mcap", 0.0, false);
    auto opened = SessionComparison::open(folder_ / "played.mcap", folder_,
                                          [this](const std::string& line) { said_.push_back(line); });
    ASSERT_TRUE(opened) << to_string(opened.error());
    comparison_ = std::move(opened).value();
  }
  void TearDown() override {
    comparison_.reset();
    std::filesystem::remove_all(folder_);
  }
  [[nodiscard]] msg::ComparisonState state() const { return comparison_->state(); }
  msg::ComparisonState complete() const {
    while (!state().complete()) std::this_thread::yield();
    return state();
  }

  std::filesystem::path folder_;
  std::vector<std::string> said_;  // read it after complete()
  std::unique_ptr<SessionComparison> comparison_;
};

TEST_F(Comparison, SaysThatDamagedStatesAreLeftOut) {
  std::vector<wire::Message> messages;
  for (int i = 0; i < 10; ++i)
    messages.push_back(wire::make_message(wire::kStationState, session_time(kStart_ns + i), msg::StationState()));
  messages[4].payload = std::make_shared<const std::string>("\xff\xff");
  std::filesystem::remove(folder_ / "other.mcap");
  ASSERT_TRUE(wire::samples::write_file(folder_ / "other.mcap", messages, {.bytes = 3000}));
  ASSERT_TRUE(comparison_->apply(R"({"with": "other.mcap"})"));
  (void)complete();
  ASSERT_EQ(said_.size(), 1u);
  EXPECT_NE(said_[0].find("leaves out a part of other.mcap: 1 damaged part"), std::string::npos) << said_[0];
}

TEST_F(Comparison, ListsTheFolderAndComparesTheChosenSession) {
  EXPECT_EQ(state().sessions_size(), 3);
  EXPECT_EQ(state().with(), "");
  ASSERT_TRUE(comparison_->apply(R"({"with": "other.mcap"})"));
  const msg::ComparisonState compared = complete();
  EXPECT_EQ(compared.with(), "other.mcap");
  EXPECT_EQ(compared.problem(), "");
  EXPECT_NEAR(compared.first().apart_n(), 0.5, 1e-6);
  ASSERT_TRUE(comparison_->apply(R"({"with": ""})"));
  EXPECT_EQ(state().apart_n_size(), 0);
}

TEST_F(Comparison, RefusesFilesThatItDoesNotList) {
  for (const char* name : {"../played.mcap", "/etc/passwd", "none.mcap"})
    EXPECT_FALSE(comparison_->apply(std::string(R"({"with": ")") + name + "\"}")) << name;
  EXPECT_FALSE(comparison_->apply("{"));
  EXPECT_FALSE(SessionComparison::open(folder_ / "played.mcap", folder_ / "played.mcap"));
}

TEST_F(Comparison, SaysWhyASessionWithoutAStationIsNotCompared) {
  ASSERT_TRUE(comparison_->apply(R"({"with": "camera.mcap"})"));
  EXPECT_NE(complete().problem().find("camera.mcap"), std::string::npos);
  EXPECT_EQ(complete().apart_n_size(), 0);
}

}  // namespace
}  // namespace telepalp::playback
