// A recorded session is published again: bytes as recorded, instants consistent, and moved by commands.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <fstream>

#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "server/playback/retimed.h"
#include "server/playback/session_events.h"
#include "server/playback/session_player.h"
#include "support/program/message_json.h"
#include "tests/proto/mcap_samples.h"

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;
using wire::samples::kStart_ns;

SessionTime at_ms(std::int64_t ms) { return session_time(kStart_ns + ms * 1'000'000); }

wire::Message depth_at(codec::DepthEncoder& encoder, int frame) {
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24, 800)};
  image.samples[static_cast<std::size_t>(frame) % image.samples.size()] = 700;
  const std::int64_t now = kStart_ns + std::int64_t{frame} * 33'000'000;
  msg::DepthImage depth;
  depth.set_captured_ns(static_cast<std::uint64_t>(now - 9'000'000));
  depth.set_encoded_ns(static_cast<std::uint64_t>(now - 1'000'000));
  depth.set_sequence(static_cast<std::uint64_t>(frame));
  const codec::EncodedDepth encoded = encoder.encode(image);
  depth.set_data(encoded.bytes);
  return wire::make_message(wire::kCameraDepth, session_time(now), depth, encoded.key_frame);
}

/// `frames` depth images at 30 Hz in groups of twelve, a camera model at the beginning, a station's state with each.
std::filesystem::path session(const std::string& name, int frames) {
  const auto file = wire::samples::fresh_file(name + std::to_string(::getpid()) + ".mcap");
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 12});
  std::vector<wire::Message> messages{wire::make_message(wire::kCameraInfo, at_ms(0), ::foxglove::CameraCalibration())};
  for (int frame = 0; frame < frames; ++frame) {
    messages.push_back(depth_at(encoder, frame));
    msg::StationState state;
    state.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(messages.back().published)));
    state.set_sender(7);
    messages.push_back(wire::make_message(wire::kStationState, messages.back().published, state));
    messages.push_back(wire::make_message(wire::kServerStats, messages.back().published, msg::ServerStats()));
  }
  EXPECT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  return file;
}

msg::DepthImage depth_of(const wire::Message& message) {
  msg::DepthImage depth;
  EXPECT_TRUE(depth.ParseFromString(*message.payload));
  return depth;
}

/// A player and what it published, on a network thread of its own that is this one.
struct Stage {
  boost::asio::io_context io;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stays{io.get_executor()};
  wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  std::vector<wire::Message> messages;
  bool ended = false;
  std::unique_ptr<SessionPlayer> player;

  explicit Stage(const PlaybackSpec& spec, bool loop = false) {
    auto opened = SessionPlayer::open(spec, loop, clock);
    EXPECT_TRUE(opened) << to_string(opened.error());
    player = std::move(opened).value();
    player->start(io, {.on_message = [this](wire::Message message) { messages.push_back(std::move(message)); },
                       .on_end = [this] { ended = true; }});
  }
  ~Stage() { player->stop(); }
  std::vector<wire::Message> on(std::string_view topic) const {
    std::vector<wire::Message> chosen;
    for (const wire::Message& message : messages)
      if (message.topic.name == topic) chosen.push_back(message);
    return chosen;
  }
  std::vector<std::uint64_t> shown() const {
    std::vector<std::uint64_t> numbers;
    for (const wire::Message& message : on("/camera/depth")) numbers.push_back(depth_of(message).sequence());
    return numbers;
  }
  template <class Done>
  bool run_until(Done done) {
    const auto limit = std::chrono::steady_clock::now() + 10s;
    while (!done() && std::chrono::steady_clock::now() < limit) io.run_one_for(5ms);
    return done();
  }
  void run_for(std::chrono::milliseconds time) { io.run_for(time); }
  void command(const std::string& json) {
    const auto read = read_command(json);
    ASSERT_TRUE(read) << to_string(read.error());
    const auto applied = player->apply(*read);
    ASSERT_TRUE(applied) << to_string(applied.error());
  }
};

TEST(Timeline, ASeekReturnsTheCameraModelAndTheGroupAndNextGoesOnFromThere) {
  auto timeline = Timeline::open(session("seek", 60), {"/camera/*"});
  ASSERT_TRUE(timeline) << to_string(timeline.error());
  const auto needed = timeline->seek(at_ms(33 * 30));  // frame 30 is in the group of the frames 24 to 35
  ASSERT_EQ(needed.size(), 1u + 6u);
  EXPECT_EQ(needed.front().topic.name, wire::kCameraInfo.name);
  codec::DepthDecoder decoder;
  for (std::size_t number = 1; number < needed.size(); ++number)
    EXPECT_TRUE(decoder.decode(std::as_bytes(std::span(depth_of(needed[number]).data()))));
  const auto next = timeline->next();
  ASSERT_TRUE(next);
  EXPECT_EQ(depth_of(*next).sequence(), 30u);
  EXPECT_TRUE(decoder.decode(std::as_bytes(std::span(depth_of(*next).data()))));
}

/// What a receiver that decodes `messages` in order cannot decode.
int undecodable(const std::vector<wire::Message>& messages) {
  codec::DepthDecoder decoder;
  int failed = 0;
  for (const wire::Message& message : messages)
    if (message.topic.predicted) failed += decoder.decode(std::as_bytes(std::span(depth_of(message).data()))) ? 0 : 1;
  return failed;
}

TEST(Timeline, ASeekFindsTheKeyFrameOfAGroupThatBeganLongBefore) {
  const auto file = wire::samples::fresh_file("long_group" + std::to_string(::getpid()) + ".mcap");
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 1000});
  std::vector<wire::Message> messages;
  for (int frame = 0; frame < 400; ++frame) messages.push_back(depth_at(encoder, frame));
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  auto timeline = Timeline::open(file, {"/camera/*"});
  ASSERT_TRUE(timeline) << to_string(timeline.error());
  const auto needed = timeline->seek(at_ms(33 * 390));
  EXPECT_EQ(needed.size(), 390u) << "the key frame lies 12.9 s before";
  EXPECT_EQ(undecodable(needed), 0);
}

TEST(Timeline, AFileOfAnEarlierReleaseHasItsKeyFrames) {
  const auto file = wire::samples::fresh_file("old" + std::to_string(::getpid()) + ".mcap");
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 12});
  std::vector<wire::Message> messages;
  for (int frame = 0; frame < 60; ++frame) messages.push_back(depth_at(encoder, frame));
  wire::samples::write_unmarked_file(file, messages, {.bytes = 3000});
  auto timeline = Timeline::open(file, {"/camera/*"});
  ASSERT_TRUE(timeline) << to_string(timeline.error());
  const auto needed = timeline->seek(at_ms(33 * 30));
  ASSERT_EQ(needed.size(), 6u);
  EXPECT_TRUE(needed.front().key_frame);
  EXPECT_EQ(undecodable(needed), 0);
  for (int frame = 30; frame < 60; ++frame) EXPECT_EQ(timeline->next()->key_frame, frame % 12 == 0);
}

TEST(Timeline, ASeekReturnsTheLastColourImageSoThatAPausedPictureHasTheColourOfItsDepth) {
  const auto file = wire::samples::fresh_file("colour" + std::to_string(::getpid()) + ".mcap");
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 12});
  std::vector<wire::Message> messages;
  for (int frame = 0; frame < 30; ++frame) {
    messages.push_back(depth_at(encoder, frame));
    ::foxglove::CompressedImage colour;
    colour.set_data("colour " + std::to_string(frame));
    messages.push_back(wire::make_message(wire::kCameraColor, messages.back().published + 1ms, colour));
  }
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  auto timeline = Timeline::open(file, {"/camera/*"});
  ASSERT_TRUE(timeline) << to_string(timeline.error());
  const auto needed = timeline->seek(at_ms(33 * 15));
  ASSERT_EQ(needed.size(), 3u + 1u) << "the depth images 12 to 14, and the colour of the last one";
  ::foxglove::CompressedImage colour;
  ASSERT_TRUE(colour.ParseFromString(*needed.back().payload));
  EXPECT_EQ(colour.data(), "colour 14");
}

TEST(Timeline, ASeekReturnsTheStatesAroundThePictureSoThatAPausedPictureShowsTheHand) {
  auto timeline = Timeline::open(session("hand", 60), {"/camera/depth", "/station/state"});
  ASSERT_TRUE(timeline) << to_string(timeline.error());
  const SessionTime at = at_ms(33 * 30);
  int states = 0;
  for (const wire::Message& message : timeline->seek(at)) {
    if (message.topic.name != wire::kStationState.name) continue;
    EXPECT_GE(message.published, at - 150ms);
    ++states;
  }
  EXPECT_EQ(states, 4) << "this session has a state with each picture";
}

TEST(Timeline, AFileWithoutTheTopicsIsAnError) {
  const auto timeline = Timeline::open(session("none", 3), {"/nothing/*"});
  ASSERT_FALSE(timeline);
  EXPECT_NE(timeline.error().what.find("no message on the topics"), std::string::npos);
}

TEST(Retimed, KeepsTheBytesAndAllAgesAtTheSpeedAndTellsSendersApart) {
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Fast});
  const wire::Message recorded = depth_at(encoder, 3);
  for (const double speed : {0.1, 1.0, 4.0}) {
    const TimeMap map{.recorded = at_ms(0), .now = session_time(5'000'000'000), .speed = speed};
    const auto played = retimed(recorded, map);
    ASSERT_TRUE(played);
    const msg::DepthImage before = depth_of(recorded);
    const msg::DepthImage after = depth_of(*played);
    EXPECT_EQ(after.data(), before.data());
    EXPECT_TRUE(played->key_frame);
    EXPECT_NEAR(static_cast<double>(after.encoded_ns() - after.captured_ns()), 8e6 / speed, 1.0);
    EXPECT_NEAR(static_cast<double>(to_nanoseconds(played->published)) - static_cast<double>(after.captured_ns()),
                9e6 / speed, 1.0);
  }
  msg::StationState state;
  state.set_stamp_ns(kStart_ns);
  state.set_sender(7);
  const auto played = retimed(wire::make_message(wire::kStationState, at_ms(0), state),
                              {.recorded = at_ms(0), .now = session_time(42), .speed = 1.0});
  msg::StationState after;
  ASSERT_TRUE(after.ParseFromString(*played->payload));
  EXPECT_EQ(after.sender(), 7u + kRecordedSenders);
  EXPECT_EQ(after.stamp_ns(), 42u);
  EXPECT_EQ(after.surface_captured_ns(), 0u) << "0 means none, and stays so";
}

TEST(Retimed, APayloadThatIsNotOfItsTypeIsLeftOut) {
  const wire::Message broken{wire::kStationState, at_ms(0), std::make_shared<const std::string>("\xff\xff\xff"), 0,
                             true};
  EXPECT_FALSE(retimed(broken, {}));
}

TEST(SessionPlayer, PlaysEachMessageOnceInTimeWithTheRecordedBytesAndEnds) {
  const auto file = session("play", 20);
  Stage stage({.file = file.string()});
  const SessionTime began = stage.clock.now();
  ASSERT_TRUE(stage.run_until([&] { return stage.ended; }));
  EXPECT_GE(stage.clock.now() - began, 600ms) << "20 images at 30 Hz";
  const auto depth = stage.on("/camera/depth");
  ASSERT_EQ(depth.size(), 20u);
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 12});
  for (int frame = 0; frame < 20; ++frame) {
    const msg::DepthImage played = depth_of(depth[static_cast<std::size_t>(frame)]);
    EXPECT_EQ(played.data(), depth_of(depth_at(encoder, frame)).data());
    EXPECT_EQ(depth[static_cast<std::size_t>(frame)].key_frame, frame % 12 == 0);
  }
  EXPECT_EQ(to_nanoseconds(depth[19].published) - to_nanoseconds(depth[0].published), 19 * 33'000'000);
  EXPECT_EQ(stage.on("/station/state").size(), 20u);
  EXPECT_TRUE(stage.on("/server/stats").empty()) << "the server states its own";
  msg::CaptureStatus last;
  ASSERT_TRUE(last.ParseFromString(*stage.on("/camera/status").back().payload));
  EXPECT_EQ(last.state(), msg::CAPTURE_STATE_ENDED);
}

TEST(SessionPlayer, AfterItsEndCommandsAreRefusedBecauseTheServerEnds) {
  Stage stage({.file = session("over", 3).string(), .speed = 4.0});
  ASSERT_TRUE(stage.run_until([&] { return stage.ended; }));
  for (const char* json : {"{\"seek_s\": 0}", "{\"play\": true}", "{\"loop\": true}"}) {
    const auto applied = stage.player->apply(*read_command(json));
    ASSERT_FALSE(applied) << json;
    EXPECT_NE(applied.error().what.find("the session is over"), std::string::npos) << to_string(applied.error());
  }
  EXPECT_FALSE(stage.player->state().playing());
}

TEST(SessionPlayer, InALoopItBeginsAgainAndTimeGoesOn) {
  Stage stage({.file = session("loop", 6).string(), .speed = 4.0}, true);
  ASSERT_TRUE(stage.run_until([&] { return stage.shown().size() >= 18; }));
  const auto depth = stage.on("/camera/depth");
  for (std::size_t number = 1; number < depth.size(); ++number)
    EXPECT_GE(depth_of(depth[number]).captured_ns(), depth_of(depth[number - 1]).captured_ns());
  EXPECT_EQ(stage.shown()[6], 0u);
  EXPECT_FALSE(stage.ended);
}

TEST(SessionPlayer, PausesStepsSeeksAndGoesOn) {
  Stage stage({.file = session("moves", 300).string(), .from_s = 1.0, .paused = true});
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty(); }));
  stage.run_for(100ms);
  EXPECT_EQ(stage.shown(), (std::vector<std::uint64_t>{24, 25, 26, 27, 28, 29, 30})) << "the group up to 1 s";
  EXPECT_FALSE(stage.player->state().playing());
  stage.messages.clear();
  stage.command("{\"step\": 2}");
  stage.run_for(100ms);
  EXPECT_EQ(stage.shown(), (std::vector<std::uint64_t>{24, 25, 26, 27, 28, 29, 30, 31, 32})) << "the group up to it";
  stage.messages.clear();
  stage.command("{\"seek_s\": 3.3}");
  stage.run_for(100ms);
  EXPECT_EQ(stage.shown(), (std::vector<std::uint64_t>{96, 97, 98, 99}));
  EXPECT_NEAR(stage.player->state().position_s(), 3.3, 1e-6);
  stage.messages.clear();
  stage.command("{\"play\": true, \"speed\": 10}");
  ASSERT_TRUE(stage.run_until([&] { return stage.shown().size() >= 60; }));
  EXPECT_EQ(stage.shown().front(), 100u);
  const auto depth = stage.on("/camera/depth");
  EXPECT_NEAR(to_seconds(depth[59].published - depth[0].published), 59 * 0.0033, 0.001);
}

/// True if a state of the station is published with the newest depth image, as far from it as in the recording.
bool has_states_of_its_picture(const Stage& stage) {
  const auto depth = stage.on(wire::kCameraDepth.name);
  if (depth.empty()) return false;
  const std::int64_t captured_ns = static_cast<std::int64_t>(depth_of(depth.back()).captured_ns());
  for (const wire::Message& message : stage.on(wire::kStationState.name)) {
    msg::StationState state;
    if (!state.ParseFromString(*message.payload)) return false;
    // Images are captured 9 ms before they are published, and a state is published with each.
    if (std::abs(static_cast<std::int64_t>(state.stamp_ns()) - captured_ns + 24'000'000) < 1'000'000) return true;
  }
  return false;
}

TEST(SessionPlayer, EachStepPublishesTheStationsStatesOfThePictureInThePicturesTime) {
  Stage stage({.file = session("states", 300).string(), .from_s = 1.0, .paused = true});
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty(); }));
  for (std::uint64_t step = 1; step <= 100; ++step) {
    stage.messages.clear();
    stage.command("{\"step\": 1}");
    ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty() && stage.shown().back() == 30 + step; })) << step;
    stage.run_for(10ms);
    EXPECT_TRUE(has_states_of_its_picture(stage)) << step;
  }
}

TEST(SessionPlayer, EachStepBackPublishesTheImageBeforeWithTheStationsStates) {
  Stage stage({.file = session("back", 300).string(), .from_s = 5.0, .paused = true});
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty(); }));
  stage.run_for(20ms);
  ASSERT_EQ(stage.shown().back(), 151u);
  for (std::uint64_t step = 1; step <= 100; ++step) {
    stage.messages.clear();
    stage.command("{\"step_back\": 1}");
    ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty() && stage.shown().back() == 151 - step; })) << step;
    stage.run_for(10ms);
    EXPECT_TRUE(has_states_of_its_picture(stage)) << step;
  }
  stage.command("{\"step\": 1}");
  EXPECT_TRUE(stage.run_until([&] { return stage.shown().back() == 52; })) << "a step forward undoes a step back";
}

TEST(SessionPlayer, AStepBackFromTheFirstImageStaysThere) {
  Stage stage({.file = session("first", 30).string(), .from_s = 0.1, .paused = true});
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty() && stage.shown().back() == 3; }));
  stage.messages.clear();
  stage.command("{\"step_back\": 100}");
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty(); }));
  stage.run_for(50ms);
  EXPECT_EQ(stage.shown().back(), 0u);
  EXPECT_FALSE(stage.player->state().playing());
}

TEST(SessionPlayer, StatesWhereThePublishedImageLiesInTheSession) {
  Stage stage({.file = session("place", 300).string(), .from_s = 1.0, .paused = true});
  const auto expect_place = [&](double captured_s) {
    const msg::PlaybackState state = stage.player->state();
    EXPECT_EQ(state.shown_ns(), depth_of(stage.on("/camera/depth").back()).captured_ns());
    EXPECT_NEAR(state.shown_s(), captured_s, 1e-9);
  };
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty() && stage.player->state().shown_ns() > 0; }));
  stage.run_for(50ms);
  expect_place(30 * 0.033 - 0.009);
  stage.command("{\"step\": 7}");
  stage.run_for(100ms);
  expect_place(37 * 0.033 - 0.009);
  stage.command("{\"play\": true, \"speed\": 2}");
  stage.run_for(300ms);
  EXPECT_EQ(stage.player->state().shown_speed(), 2.0);
  stage.command("{\"play\": false}");
  stage.run_for(100ms);
  expect_place(static_cast<double>(stage.shown().back()) * 0.033 - 0.009);
}

TEST(SessionPlayer, PausedAtItsBeginningItShowsTheFirstPictureAndWaits) {
  Stage stage({.file = session("waits", 30).string(), .paused = true});
  ASSERT_TRUE(stage.run_until([&] { return !stage.shown().empty(); }));
  stage.run_for(100ms);
  EXPECT_EQ(stage.shown(), (std::vector<std::uint64_t>{0}));
  EXPECT_EQ(stage.on("/camera/info").size(), 1u);
  EXPECT_FALSE(stage.player->state().playing());
  stage.messages.clear();
  stage.command("{\"step\": 1}");
  ASSERT_TRUE(stage.run_until([&] { return stage.shown().size() == 2; }));
  EXPECT_EQ(stage.shown(), (std::vector<std::uint64_t>{0, 1}));
}

TEST(SessionPlayer, APausedPictureIsShownAgainAsOldAsItIsAndPlayingGoesOnBehindIt) {
  Stage stage({.file = session("again", 60).string(), .from_s = 0.9, .paused = true});
  ASSERT_TRUE(stage.run_until([&] { return stage.shown().size() == 4; }));
  const std::vector<wire::Message> before = stage.on("/camera/depth");
  stage.messages.clear();
  stage.player->show_again();
  ASSERT_TRUE(stage.run_until([&] { return stage.shown().size() == 4; })) << "the group up to the picture";
  EXPECT_EQ(stage.shown(), (std::vector<std::uint64_t>{24, 25, 26, 27}));
  EXPECT_EQ(stage.on("/camera/info").size(), 1u);
  for (std::size_t number = 0; number < before.size(); ++number)
    EXPECT_EQ(*stage.on("/camera/depth")[number].payload, *before[number].payload) << "it became younger";
  stage.messages.clear();
  stage.command("{\"play\": true, \"speed\": 10}");
  ASSERT_TRUE(stage.run_until([&] { return stage.shown().size() >= 5; }));
  EXPECT_EQ(stage.shown().front(), 28u) << "no image is lost or repeated";
  stage.player->show_again();  // while it plays, the next image is enough
  ASSERT_TRUE(stage.run_until([&] { return stage.ended; }));
  const auto shown = stage.shown();
  EXPECT_EQ(shown.size(), 32u);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
}

TEST(SessionPlayer, RefusesWhatLiesBehindTheEnd) {
  const auto file = session("refuse", 30);
  EXPECT_FALSE(SessionPlayer::open({.file = file.string(), .from_s = 60.0}, false,
                                   wire::SessionClock::anchored_to_wall_clock()));
  Stage stage({.file = file.string(), .paused = true});
  msg::PlaybackCommand command;
  command.set_seek_s(60.0);
  const auto applied = stage.player->apply(command);
  ASSERT_FALSE(applied);
  EXPECT_NE(applied.error().what.find("the session lasts"), std::string::npos);
}

TEST(SessionPlayer, ADamagedChunkIsSkippedAndCounted) {
  const auto file = session("damaged", 40);
  const auto chunk = wire::McapReader::open(file)->summary().chunks[2];
  std::string bytes = wire::samples::bytes_of(file);
  bytes[chunk.chunk_start_offset + chunk.chunk_length - 20] ^= 0x55;
  std::ofstream(file, std::ios::binary) << bytes;
  Stage stage({.file = file.string(), .speed = 10.0});
  ASSERT_TRUE(stage.run_until([&] { return stage.ended; }));
  EXPECT_LT(stage.shown().size(), 40u);
  EXPECT_GT(stage.shown().size(), 10u);
  EXPECT_GE(stage.player->state().damaged(), 1u);
}

TEST(SessionEvents, TellsTheWholeSessionBeforeItIsPlayed) {
  const auto file = wire::samples::fresh_file("events" + std::to_string(::getpid()) + ".mcap");
  std::vector<wire::Message> messages;
  for (int ms = 0; ms < 3000; ms += 30) {
    msg::StationState state;
    messages.push_back(wire::make_message(wire::kStationState, at_ms(ms), state));
    if (ms % 1500 != 0) continue;
    msg::StationEvent event;
    event.set_text("event at " + std::to_string(ms));
    event.set_to(msg::PHASE_OUT_BODY);
    messages.push_back(wire::make_message(wire::kStationEvents, at_ms(ms), event));
  }
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  const SessionEvents reading(file, at_ms(0));
  msg::SessionEvents told = reading.events();
  for (int look = 0; look < 3000 && !told.complete(); ++look) {
    std::this_thread::sleep_for(10ms);
    told = reading.events();
  }
  ASSERT_EQ(told.events_size(), 2);
  EXPECT_DOUBLE_EQ(told.events(0).at_s(), 0.0);
  EXPECT_DOUBLE_EQ(told.events(1).at_s(), 1.5);
  EXPECT_EQ(told.events(1).text(), "event at 1500");
  EXPECT_EQ(told.events(1).to(), msg::PHASE_OUT_BODY);
  EXPECT_NE(program::to_json(told).find("\"complete\":true"), std::string::npos);
  std::filesystem::remove(file);
}

/// The events of `file`, and the line about those that the list lacks.
std::pair<msg::SessionEvents, std::string> events_of(const std::filesystem::path& file) {
  std::string said;
  const SessionEvents reading(file, at_ms(0), [&](const std::string& line) { said += line; });
  for (int look = 0; look < 3000 && !reading.events().complete(); ++look) std::this_thread::sleep_for(10ms);
  return {reading.events(), said};
}

TEST(SessionEvents, AFileThatCannotBeReadHasNoneAndIsCompleteAndSaysSo) {
  const auto [events, said] = events_of("/nonexistent.mcap");
  EXPECT_TRUE(events.complete()) << "a page asks until it is";
  EXPECT_EQ(events.events_size(), 0);
  EXPECT_NE(said.find("list of events of nonexistent.mcap is empty"), std::string::npos) << said;
}

TEST(SessionEvents, SaysWhichEventsTheListLacks) {
  const auto file = wire::samples::fresh_file("lacking" + std::to_string(::getpid()) + ".mcap");
  std::vector<wire::Message> messages;
  for (int ms = 0; ms < 5001; ++ms)
    messages.push_back(wire::make_message(wire::kStationEvents, at_ms(ms), msg::StationEvent()));
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  EXPECT_NE(events_of(file).second.find("ends after 5000 events"), std::string::npos) << events_of(file).second;
  messages.erase(messages.begin() + 10, messages.end());
  std::filesystem::remove(file);
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  EXPECT_EQ(events_of(file).second, "");
  messages[3].payload = std::make_shared<const std::string>("\xff\xff");
  std::filesystem::remove(file);
  ASSERT_TRUE(wire::samples::write_file(file, messages, {.bytes = 3000}));
  EXPECT_NE(events_of(file).second.find("lacks the events of 1 damaged part"), std::string::npos)
      << events_of(file).second;
  EXPECT_EQ(events_of(file).first.events_size(), 9);
  std::filesystem::remove(file);
}

TEST(PlaybackCommand, WrongJsonAndValuesOutOfRangeAreNamed) {
  for (const char* wrong :
       {"", "[]", "{\"speed\": 0.01}", "{\"speed\": \"nan\"}", "{\"step\": 0}", "{\"step\": 101}", "{\"step_back\": 0}",
        "{\"step_back\": 101}", "{\"seek_s\": -1}", "{\"faster\": true}", "{\"play\": 3}"})
    EXPECT_FALSE(read_command(wrong)) << wrong;
  EXPECT_TRUE(read_command("{}"));
}

TEST(PlaybackSpec, IsReadBehindTheFileAndWrongWordsAreNamed) {
  const auto spec = read_spec("a,b.mcap,from_s=12.5,speed=0.5,paused=yes,topics=/camera/*+/clock");
  ASSERT_TRUE(spec) << to_string(spec.error());
  EXPECT_EQ(spec->file, "a,b.mcap");
  EXPECT_EQ(spec->from_s, 12.5);
  EXPECT_EQ(spec->speed, 0.5);
  EXPECT_TRUE(spec->paused);
  EXPECT_EQ(spec->topics, (std::vector<std::string>{"/camera/*", "/clock"}));
  for (const char* wrong :
       {"a.mcap,", "a.mcap,fast", "a.mcap,speed=20", "a.mcap,speed=nan", "a.mcap,paused=maybe", "a.mcap,from_s=-1"})
    EXPECT_FALSE(read_spec(wrong)) << wrong;
}

}  // namespace
}  // namespace telepalp::playback
