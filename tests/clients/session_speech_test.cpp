// Where people speak in a session: found by loudness, kept by the recorder, read by the page's server and the report.

#include "support/speech/session_speech.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "clients/record/edit/cut.h"
#include "clients/record/live/session_files.h"
#include "clients/report/figures/speech_figures.h"
#include "clients/report/session/session_file.h"
#include "messages/voice.pb.h"
#include "server/playback/session_events.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/spoken_messages.h"

namespace telepalp::speech {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kBegin = session_time(1'700'000'000'000'000'000);

std::vector<wire::Message> joined(std::vector<wire::Message> a, const std::vector<wire::Message>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::stable_sort(a, {}, &wire::Message::published);
  return a;
}

/// The patient's side speaks from 0 to 2 s and from 6 to 7 s, the doctor from 3 to 5 s.
std::vector<wire::Message> conversation() {
  return joined(joined(support::spoken_messages(wire::kPatientVoice, kBegin, 0, 100),
                       support::spoken_messages(wire::kPatientVoice, kBegin, 300, 350)),
                support::spoken_messages(wire::kDoctorVoice, kBegin, 150, 250, 2));
}

std::filesystem::path in(const std::string& name) {
  return wire::samples::fresh_file(name + std::to_string(::getpid()) + ".mcap");
}

/// What the recorder writes of `messages`.
std::filesystem::path recorded(const std::string& name, const std::vector<wire::Message>& messages) {
  const std::filesystem::path file = in(name);
  auto files = record::SessionFiles::open(
      {.name = file, .session = wire::samples::kInfo, .attachments = {}, .splitting = {}}, [](const std::string&) {});
  EXPECT_TRUE(files) << to_string(files.error());
  for (const wire::Message& message : messages) (*files)->write(message);
  EXPECT_TRUE((*files)->close({"telepalp.recording", {}}));
  return file;
}

wire::McapReader open(const std::filesystem::path& file) {
  auto reader = wire::McapReader::open(file);
  EXPECT_TRUE(reader) << to_string(reader.error());
  return std::move(reader).value();
}

void expect_spans(const SideSpeech& side, const std::vector<std::pair<double, double>>& expected_s) {
  ASSERT_EQ(side.spans.size(), expected_s.size());
  for (std::size_t i = 0; i < expected_s.size(); ++i) {
    EXPECT_NEAR(to_seconds(side.spans[i].from - kBegin), expected_s[i].first, 0.2);
    EXPECT_NEAR(to_seconds(side.spans[i].until - kBegin), expected_s[i].second, 0.2);
    EXPECT_GT(side.spans[i].loudest_dB, -30);
    EXPECT_LE(side.spans[i].loudest_dB, 0);
  }
}

void expect_conversation(const Speech& speech) {
  ASSERT_EQ(speech.size(), 2u);
  expect_spans(speech.at(wire::kPatientVoice.name), {{0.0, 2.0}, {6.0, 7.0}});
  expect_spans(speech.at(wire::kDoctorVoice.name), {{3.0, 5.0}});
}

TEST(SessionSpeech, TheRecorderStatesWhereEachSideSpeaksAndNobodyNeedsToReadTheWords) {
  const auto file = recorded("stated", conversation());
  wire::McapReader reader = open(file);
  const auto speech = recorded_speech(reader);
  ASSERT_TRUE(speech);
  expect_conversation(*speech);
  std::filesystem::remove(file);
}

TEST(SessionSpeech, AFileWithoutARecordOfItIsSurveyed) {
  const auto file = in("surveyed");
  ASSERT_TRUE(wire::samples::write_file(file, conversation(), {.bytes = 5000}));
  wire::McapReader reader = open(file);
  EXPECT_FALSE(recorded_speech(reader));
  expect_conversation(surveyed_speech(reader));
  std::filesystem::remove(file);
}

TEST(SessionSpeech, ACutFileIsSurveyedBecauseItsRecordTellsOfMoreThanItHas) {
  const auto file = recorded("whole", conversation());
  const auto out = in("cut");
  record::CutOptions options;
  options.from = 4s;
  ASSERT_TRUE(record::cut(file, out, options));
  wire::McapReader reader = open(out);
  EXPECT_FALSE(recorded_speech(reader));
  const Speech speech = surveyed_speech(reader);
  expect_spans(speech.at(wire::kPatientVoice.name), {{6.0, 7.0}});
  expect_spans(speech.at(wire::kDoctorVoice.name), {{4.0, 5.0}});
  std::filesystem::remove(file);
  std::filesystem::remove(out);
}

TEST(SessionSpeech, ASessionWithoutSpeechHasNeitherARecordNorLanes) {
  msg::StationState state;
  const auto file = recorded("silent", {wire::make_message(wire::kStationState, kBegin, state)});
  wire::McapReader reader = open(file);
  const auto speech = recorded_speech(reader);
  ASSERT_TRUE(speech);
  EXPECT_TRUE(speech->empty());
  EXPECT_TRUE(
      std::ranges::none_of(reader.summary().metadata, [](const auto& one) { return one.name == kSpeechMetadata; }));
  std::filesystem::remove(file);
}

TEST(SessionSpeech, ADamagedRecordIsRefusedWhateverItHolds) {
  const auto whole =
      speech_record(Speech{{wire::kDoctorVoice.name, {.spans = {{kBegin, kBegin + 1s, -20}}, .messages = 50}}});
  ASSERT_TRUE(whole);
  std::string many = "50 0";
  for (std::size_t i = 0; i <= LoudSpans::kMost; ++i) many += " 0 1 -20";
  for (const std::string& text :
       {std::string(), std::string("50"), std::string("50 0 5"), std::string("50 0 5 4 -20"), std::string("50 0 1 2 3"),
        std::string("50 0 1 2 -101"), std::string("-1 0"), std::string("50 99999999999999999999"),
        std::string("50 0 a b c"), std::string("50 0 1 99999999999999 -3"), std::string("50 0  1 2 -3"), many,
        std::string(200'000, '1')}) {
    const auto file = in("damaged_record");
    auto writer = wire::McapWriter::open(file, wire::samples::kInfo, {});
    ASSERT_TRUE(writer);
    for (const wire::Message& message : support::spoken_messages(wire::kDoctorVoice, kBegin, 0, 50))
      ASSERT_TRUE(writer->write(message));
    wire::mcap::Metadata record = *whole;
    record.values.begin()->second = text;
    ASSERT_TRUE(writer->add(record));
    ASSERT_TRUE(writer->close());
    wire::McapReader reader = open(file);
    EXPECT_FALSE(recorded_speech(reader)) << text.substr(0, 40);
    std::filesystem::remove(file);
  }
}

TEST(SessionSpeech, AnHourOfShortWordsStaysBoundedAndQuickAndInOrder) {
  LoudSpans loud;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> pause_s(0.6, 1.4);
  SessionTime at = kBegin;
  std::size_t words = 0;
  for (; at < kBegin + 3600s; ++words) {
    for (int frame = 0; frame < 10; ++frame, at += kVoiceFrameTime) loud.add(at, -25.0);
    const SessionTime until = at + from_seconds(pause_s(random));
    for (; at < until; at += kVoiceFrameTime) loud.add(at, -90.0);
  }
  const std::vector<Spoken> spans = loud.spans();
  EXPECT_GT(words, 2 * LoudSpans::kMost);
  EXPECT_LE(spans.size(), LoudSpans::kMost);
  EXPECT_GE(spans.size(), LoudSpans::kMost / 8);
  for (std::size_t i = 1; i < spans.size(); ++i) ASSERT_LT(spans[i - 1].until, spans[i].from);
  EXPECT_LT(speech_record(Speech{{wire::kDoctorVoice.name, {spans, 1}}})->values.begin()->second.size(), 64'000u);
}

TEST(SessionSpeech, NoiseOfTheRoomIsNoSpeechAndSpeechAboveItIs) {
  LoudSpans loud;
  SessionTime at = kBegin;
  const auto lasts = [&](double level, int frames) {
    for (; frames > 0; --frames, at += kVoiceFrameTime) loud.add(at, level);
  };
  lasts(-42.0, 3000);  // a fan, for a minute
  lasts(-25.0, 50);
  lasts(-42.0, 100);
  lasts(-20.0, 2);  // a click
  lasts(-42.0, 100);
  const std::vector<Spoken> spans = loud.spans();
  ASSERT_FALSE(spans.empty());
  EXPECT_EQ(spans.back().from, kBegin + 60s);
  EXPECT_EQ(spans.back().until, kBegin + 61s);
  EXPECT_LT(to_seconds(spans.front().from - kBegin), 20.0) << "until the fan is known, it counts";
  EXPECT_LE(spans.size(), 2u);
}

TEST(SessionSpeech, AnybodysMessagesKeepItBounded) {
  SpeechSurvey survey;
  std::vector<wire::Message> messages = support::spoken_messages(wire::kDoctorVoice, kBegin, 0, 60);
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    wire::Message message = messages[random() % messages.size()];
    msg::VoiceFrame frame;
    ASSERT_TRUE(frame.ParseFromString(*message.payload));
    frame.set_captured_ns(i % 3 == 0 ? UINT64_MAX : random());
    frame.set_number(i % 2 == 0 ? UINT32_MAX - 2 : frame.number());
    message = wire::make_message(message.topic, kBegin + std::chrono::milliseconds(random() % 60'000), frame);
    if (i % 5 == 0) message.payload = std::make_shared<const std::string>(std::string(random() % 5000, '\x0a'));
    survey.add(message);
  }
  const Speech speech = survey.speech();
  EXPECT_EQ(speech.at(wire::kDoctorVoice.name).messages, 2000u);
  EXPECT_LE(speech.at(wire::kDoctorVoice.name).spans.size(), LoudSpans::kMost);
}

TEST(SessionSpeech, TheServerTellsThePageOfBothKindsOfFile) {
  const auto surveyed = in("events_surveyed");
  ASSERT_TRUE(wire::samples::write_file(surveyed, conversation(), {.bytes = 5000}));
  for (const auto& file : {recorded("events_stated", conversation()), surveyed}) {
    const playback::SessionEvents events(file, kBegin);
    for (int look = 0; look < 1000 && events.events().speech_size() < 3; ++look) std::this_thread::sleep_for(10ms);
    const msg::SessionEvents told = events.events();
    ASSERT_EQ(told.speech_size(), 3);
    const auto doctor = std::ranges::find_if(told.speech(), [](const auto& one) { return one.doctor(); });
    ASSERT_NE(doctor, told.speech().end());
    EXPECT_NEAR(doctor->from_s(), 3.0, 0.12);
    EXPECT_NEAR(doctor->until_s(), 5.0, 0.12);
    EXPECT_GT(doctor->loudest_db(), -30);
    std::filesystem::remove(file);
  }
}

TEST(SessionSpeech, TheReportDrawsALaneOfEachSide) {
  const auto file = recorded("report", conversation());
  const auto session = report::read_session(file);
  ASSERT_TRUE(session) << to_string(session.error());
  const std::vector<plot::Chart> lanes = report::speech_lanes(*session);
  ASSERT_EQ(lanes.size(), 2u);
  EXPECT_EQ(lanes[0].title, "speech: the patient's side");
  const std::string svg = plot::to_svg(lanes[0]);
  EXPECT_NE(svg.find("<polygon"), std::string::npos) << svg;
  const std::string words = report::speech_words(*session);
  EXPECT_NE(words.find("the patient's side spoke for "), std::string::npos) << words;
  EXPECT_NE(words.find(", 2 times; the doctor spoke for "), std::string::npos) << words;
  EXPECT_NE(words.find(", 1 time."), std::string::npos) << words;
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace telepalp::speech
