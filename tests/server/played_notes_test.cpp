// Words on the picture of a played session.

#include "server/origin/played_notes.h"

#include <gtest/gtest.h>

#include <utility>

namespace telepalp::origin {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kNow{1h};

wire::ToldNote note(double at_s, const std::string& text) {
  wire::ToldNote note{.at_s = at_s};
  note.note.set_at_ns(5);
  note.note.set_text(text);
  note.note.mutable_at_m()->set_z(0.8);
  return note;
}

std::string words(const msg::MarksState& state) {
  std::string all;
  for (const msg::LiveNote& one : state.newest()) all += one.text() + ' ';
  return all;
}

TEST(PlayedNotes, StandFromTheirMomentForTwentySecondsOfTheSession) {
  PlayedNotes notes({note(10.0, "turn"), note(25.0, "here")});
  EXPECT_EQ(words(notes.at(9.9, kNow)), "");
  const msg::MarksState& first = notes.at(10.0, kNow);
  EXPECT_EQ(words(first), "turn ");
  EXPECT_TRUE(first.closed());
  EXPECT_DOUBLE_EQ(first.newest(0).at_m().z(), 0.8);
  EXPECT_EQ(words(notes.at(26.0, kNow + 16s)), "turn here ");
  EXPECT_EQ(words(notes.at(31.0, kNow + 21s)), "here ");
  EXPECT_EQ(words(notes.at(50.0, kNow + 40s)), "");
}

TEST(PlayedNotes, ASeekShowsWhatStandsThereAndTakesAwayWhatComesLater) {
  PlayedNotes notes({note(10.0, "turn"), note(25.0, "here")});
  EXPECT_EQ(words(notes.at(28.0, kNow)), "turn here ");
  EXPECT_EQ(words(notes.at(12.0, kNow + 1s)), "turn ");
  EXPECT_EQ(notes.at(12.0, kNow + 1s).count(), 1U);
}

TEST(PlayedNotes, WhileASessionIsPausedAPageNeitherLosesAWordNorIsToldItAgainAndAgain) {
  PlayedNotes notes({note(10.0, "turn")});
  std::uint64_t told = 0;
  std::uint64_t last = 0;
  for (Nanoseconds paused = 0ms; paused < 60s; paused += 100ms) {
    const msg::MarksState& state = notes.at(12.0, kNow + paused);
    ASSERT_EQ(state.newest_size(), 1);
    EXPECT_LT(to_nanoseconds(kNow + paused) - static_cast<std::int64_t>(state.newest(0).at_ns()),
              Nanoseconds(PlayedNotes::kStands).count());
    if (std::exchange(last, state.newest(0).at_ns()) != state.newest(0).at_ns()) ++told;
  }
  EXPECT_LE(told, 5U);
}

TEST(PlayedNotes, OfManyTheFourNewestStand) {
  std::vector<wire::ToldNote> many;
  for (int i = 0; i < 9; ++i) many.push_back(note(i, std::to_string(i)));
  PlayedNotes notes(std::move(many));
  EXPECT_EQ(words(notes.at(8.5, kNow)), "5 6 7 8 ");
}

}  // namespace
}  // namespace telepalp::origin
