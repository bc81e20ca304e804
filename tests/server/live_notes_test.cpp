// Moments that people mark while the session takes place.

#include "server/origin/live_notes.h"

#include <gtest/gtest.h>

#include <vector>

#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/topics.h"

namespace telepalp::origin {
namespace {

class Marking : public testing::Test {
 protected:
  void SetUp() override {
    notes_.start([this](wire::Message message) {
      EXPECT_EQ(message.topic.name, wire::kSessionNotes.name);
      msg::LiveNote note;
      EXPECT_TRUE(note.ParseFromString(*message.payload));
      published_.push_back(note);
    });
  }
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  LiveNotes notes_{clock_};
  std::vector<msg::LiveNote> published_;
};

TEST_F(Marking, TheMomentIsThatOfThePictureThatTheWriterSaw) {
  const std::int64_t before_ns = to_nanoseconds(clock_.now());
  ASSERT_TRUE(notes_.mark(R"({"text": "tender here"})", "doctor Anna").ok());
  const std::int64_t after_ns = to_nanoseconds(clock_.now());
  ASSERT_EQ(published_.size(), 1u);
  EXPECT_EQ(published_[0].text(), "tender here");
  EXPECT_EQ(published_[0].who(), "doctor Anna");
  EXPECT_FALSE(published_[0].written().empty());
  EXPECT_GE(static_cast<std::int64_t>(published_[0].at_ns()), before_ns);
  EXPECT_LE(static_cast<std::int64_t>(published_[0].at_ns()), after_ns);
  ASSERT_TRUE(notes_.mark(R"({"ago_s": 60})", "doctor Anna").ok());
  EXPECT_LE(published_[1].at_ns(), published_[0].at_ns());
  EXPECT_EQ(notes_.state().count(), 2u);
}

TEST_F(Marking, AWrongCommandIsNamedAndMarksNothing) {
  const std::string longest(wire::kMostNoteText_B + 1, 'x');
  for (const std::string& wrong :
       {std::string("nonsense"), std::string(R"({"ago_s": -1})"), std::string(R"({"ago_s": "NaN"})"),
        std::string(R"({"ago_s": 61})"), std::string(R"({"at_m": {"z": 10.1}})"), std::string(R"({"at_m": {"x": "NaN"}})"), std::string(R"({"text": "two\nlines"})"), R"({"text": ")" + longest + R"("})"})
    EXPECT_FALSE(notes_.mark(wrong, "doctor Anna").ok()) << wrong;
  EXPECT_TRUE(published_.empty());
  EXPECT_EQ(notes_.state().count(), 0u);
}

TEST_F(Marking, WordsAndAPlaceReachTheOthersAndTheNewestFourAreKept) {
  for (const char* text : {"one", "two", "three", "four"})
    ASSERT_TRUE(notes_.mark(std::string(R"({"text": ")") + text + "\"}", "technician Ben").ok());
  ASSERT_TRUE(notes_.mark(R"({"text": "turn him to the left", "at_m": {"x": 0.1, "z": 0.8}})", "doctor Anna").ok());
  ASSERT_EQ(notes_.state().newest_size(), 4);
  EXPECT_EQ(notes_.state().newest(0).text(), "two");
  for (const msg::LiveNote& note : {notes_.state().newest(3), published_.back()}) {
    EXPECT_EQ(note.text(), "turn him to the left");
    EXPECT_EQ(note.at_m().x(), 0.1);
    EXPECT_EQ(note.at_m().z(), 0.8);
  }
  EXPECT_FALSE(notes_.state().newest(0).has_at_m());
}

TEST_F(Marking, IsBoundedInNumber) {
  for (int i = 0; i < wire::kMostNotes; ++i) ASSERT_TRUE(notes_.mark("{}", "doctor Anna").ok());
  const Result<void> refused = notes_.mark("{}", "doctor Anna");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("1000"), std::string::npos);
  EXPECT_EQ(published_.size(), static_cast<std::size_t>(wire::kMostNotes));
}

}  // namespace
}  // namespace telepalp::origin
