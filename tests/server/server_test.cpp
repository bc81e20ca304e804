#include "server/server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <map>
#include <string>
#include <vector>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "messages/clock.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/client/client_link.h"
#include "server/origin/camera_origin.h"
#include "tests/server/still_source.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

template <class Proto>
Proto parsed(const wire::Message& message) {
  Proto proto;
  EXPECT_TRUE(proto.ParseFromString(*message.payload)) << message.topic.name;
  return proto;
}

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// A server with a source of twenty frames and one client of all topics; it runs until the server closes.
struct ServedSource {
  boost::asio::io_context io;
  std::map<std::string_view, std::vector<wire::Message>> messages;
  std::string lost_because;
  std::vector<std::string> log;

  ServedSource() {
    auto server = Server::listen(io, {.software = "telepalp-server 0.1.0, commit 1a2b3c4d",
                                      .log = [this](const std::string& line) { log.push_back(line); }});
    EXPECT_TRUE(server.ok());
    wire::ClientLink link(
        io, {.port = (*server)->port(), .name = "test", .subscribes = {"*"}},
        {.on_message = [this](const wire::Message& message) { messages[message.topic.name].push_back(message); },
         .on_state =
             [&](wire::LinkState state, const std::string& detail) {
               if (state == wire::LinkState::Connected)
                 (*server)->start(origin::of_camera(io, std::make_unique<StillSource>(20, 25ms, (*server)->clock()),
                                                    "still", {}, (*server)->clock()),
                                  [&] { (*server)->stop("the source came to its end"); });
               if (state == wire::LinkState::Lost) {
                 lost_because = detail;
                 link.stop();
               }
             }});
    link.start();
    io.run_for(20s);
  }
};

TEST(Server, PublishesEveryCameraTopicWithTheTimesOfItsFrames) {
  ServedSource run;
  ASSERT_EQ(run.messages[wire::kCameraDepth.name].size(), 20u);
  ASSERT_EQ(run.messages[wire::kCameraColor.name].size(), 20u);
  ASSERT_GE(run.messages[wire::kCameraInfo.name].size(), 1u);
  const auto depth = parsed<msg::DepthImage>(run.messages[wire::kCameraDepth.name].back());
  EXPECT_EQ(depth.sequence(), 20u);
  EXPECT_EQ(depth.width(), 64u);
  EXPECT_GE(depth.encoded_ns(), depth.captured_ns());
  const Result<DepthImage> image = codec::decode_depth(bytes_of(depth.data()));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->samples, small_frame(20, {}).depth.samples);
  EXPECT_FALSE(depth.has_bound()) << "nothing was moved";
  const auto color = parsed<foxglove::CompressedImage>(run.messages[wire::kCameraColor.name].back());
  EXPECT_EQ(color.format(), "jpeg");
  EXPECT_EQ(static_cast<std::uint64_t>(color.timestamp().seconds()) * 1'000'000'000u +
                static_cast<std::uint64_t>(color.timestamp().nanos()),
            depth.captured_ns());
  EXPECT_TRUE(codec::decode_color(bytes_of(color.data())).ok());
  const auto info = parsed<foxglove::CameraCalibration>(run.messages[wire::kCameraInfo.name].front());
  ASSERT_EQ(info.k_size(), 9);
  EXPECT_EQ(info.k(0), 60.0);
  EXPECT_EQ(info.k(5), 23.5);
  ASSERT_EQ(info.p_size(), 12);
}

TEST(Server, TheEndOfTheSourceIsPublishedAndStatedInTheGoodbye) {
  ServedSource run;
  ASSERT_FALSE(run.messages[wire::kCameraStatus.name].empty());
  const auto status = parsed<msg::CaptureStatus>(run.messages[wire::kCameraStatus.name].back());
  EXPECT_EQ(status.state(), msg::CAPTURE_STATE_ENDED);
  EXPECT_EQ(status.frames(), 20u);
  EXPECT_EQ(status.source(), "still");
  EXPECT_EQ(run.lost_because, "peer left: the source came to its end");
}

TEST(Server, ItsLastStatisticsAccountForEveryImage) {
  ServedSource run;
  ASSERT_FALSE(run.messages[wire::kServerStats.name].empty());
  const auto stats = parsed<msg::ServerStats>(run.messages[wire::kServerStats.name].back());
  for (const auto& topic : stats.topics())
    if (topic.topic() == wire::kCameraDepth.name) {
      EXPECT_EQ(topic.published(), 20u);
      EXPECT_EQ(topic.sent() + topic.dropped(), 20u);
      EXPECT_EQ(topic.sent(), run.messages[wire::kCameraDepth.name].size());
    }
  ASSERT_EQ(stats.subscribers_size(), 1);
  EXPECT_EQ(stats.subscribers(0).name(), "test");
  EXPECT_EQ(stats.software(), "telepalp-server 0.1.0, commit 1a2b3c4d");
}

TEST(Server, RefusesToListenWhereTheNetworkReachesIt) {
  boost::asio::io_context io;
  for (const char* address : {"0.0.0.0", "::", "192.168.1.2", "not an address"}) {
    const auto server = Server::listen(io, {.bind = address});
    ASSERT_FALSE(server.ok()) << address;
    EXPECT_FALSE(server.error().fix.empty());
  }
}

TEST(Server, NamesThePortThatIsInUse) {
  boost::asio::io_context io;
  const auto first = Server::listen(io, {});
  ASSERT_TRUE(first.ok());
  const auto second = Server::listen(io, {.port = (*first)->port()});
  ASSERT_FALSE(second.ok());
  EXPECT_NE(to_string(second.error()).find("port is in use"), std::string::npos);
  EXPECT_NE(second.error().where.find(std::to_string((*first)->port())), std::string::npos);
}

/// One client of a server: decodes all frames, and may request a key frame at every message.
struct Onlooker {
  codec::DepthDecoder decoder;
  std::vector<bool> is_key;
  std::uint64_t last_sequence = 0;
  int unreadable = 0;
  bool asks_always = false;
  wire::ClientLink link;

  Onlooker(boost::asio::io_context& io, std::uint16_t port)
      : link(io, {.port = port, .name = "test", .subscribes = {"/camera/depth"}, .datagrams = false},
             {.on_message = [this](const wire::Message& message) { on_depth(message); }, .on_state = {}}) {
    link.start();
  }
  void on_depth(const wire::Message& message) {
    const auto depth = parsed<msg::DepthImage>(message);
    is_key.push_back(message.key_frame);
    EXPECT_EQ(message.key_frame, codec::is_key_frame(bytes_of(depth.data())));
    last_sequence = depth.sequence();
    unreadable += decoder.decode(bytes_of(depth.data())).ok() ? 0 : 1;
    if (asks_always) link.request_key_frame(message);
  }
};

TEST(Server, TemporalDepthBeginsWithAKeyFrameForEveryoneAndNobodyCanMakeEachFrameOne) {
  boost::asio::io_context io;
  auto server = Server::listen(io, {});
  ASSERT_TRUE(server.ok());
  (*server)->start(
      origin::of_camera(io, std::make_unique<StillSource>(1000, 5ms, (*server)->clock()), "still",
                        {.depth = {.mode = codec::DepthMode::Temporal, .key_every = 1000}}, (*server)->clock()),
      [] {});
  Onlooker first(io, (*server)->port());
  const auto run_until = [&](auto done) {
    for (int i = 0; i < 4000 && !done(); ++i) io.run_one_for(5ms);
    return done();
  };
  ASSERT_TRUE(run_until([&] { return first.is_key.size() >= 20; }));
  Onlooker late(io, (*server)->port());
  ASSERT_TRUE(run_until([&] { return late.is_key.size() >= 20; }));
  EXPECT_TRUE(first.is_key.front());
  EXPECT_TRUE(late.is_key.front());
  EXPECT_EQ(first.unreadable + late.unreadable, 0);
  const auto keys_of = [](const Onlooker& onlooker, std::size_t from) {
    return std::count(onlooker.is_key.begin() + static_cast<std::ptrdiff_t>(from), onlooker.is_key.end(), true);
  };
  const std::size_t from = first.is_key.size();
  const std::uint64_t from_sequence = first.last_sequence;
  late.asks_always = true;
  ASSERT_TRUE(run_until([&] { return first.is_key.size() >= from + 40; }));
  EXPECT_GE(keys_of(first, from), 3) << "what is asked for is made";
  const auto made = static_cast<std::ptrdiff_t>(first.last_sequence - from_sequence);  // some may have been dropped
  EXPECT_LE(keys_of(first, from), made / 4 + 1) << "one in four at most";
  EXPECT_EQ(first.unreadable, 0);
  first.link.stop();
  late.link.stop();
  (*server)->stop("end of the test");
  io.run_for(2s);
}

TEST(CameraPipeline, ImagesShrinkWhileALineIsSharedAndDepthStaysExact) {
  const wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  StillSource source(7, 0ms, clock);
  std::vector<codec::DepthMode> modes;
  std::vector<std::size_t> color_B;
  std::size_t level = 0;
  const DepthImage truth = small_frame(1, {}).depth;
  pipeline::CameraPipeline pipeline(
      source, "still", {.depth = {.mode = codec::DepthMode::Fast}}, clock,
      {.publish =
           [&](const wire::Message& message, plan::Grade grade) {
             if (message.topic.name != wire::kCameraColor.name && message.topic.name != wire::kCameraDepth.name)
               return true;
             EXPECT_EQ(grade, plan::Grade::Touch) << "nobody takes another grade";
             if (message.topic.name == wire::kCameraColor.name) color_B.push_back(message.payload->size());
             if (message.topic.name != wire::kCameraDepth.name) return true;
             msg::DepthImage depth;
             EXPECT_TRUE(depth.ParseFromString(*message.payload));
             codec::DepthReader reader;
             const auto decoded = reader.read(std::as_bytes(std::span(depth.data())));
             EXPECT_TRUE(decoded);
             if (!decoded) return true;
             EXPECT_EQ(decoded->image.samples, truth.samples);
             modes.push_back(decoded->mode);
             return true;
           },
       .take_key_frame_request = [](std::string_view) { return false; },
       .wanted =
           [&] {
             pipeline::Wanted wanted{.color = {.pictures = false}, .depth = {.whole = false}};
             wanted.touch = {.color = {.pictures = true}, .depth = {.whole = true}, .settings = {.level = level}};
             return wanted;
           }});
  for (level = 0; level <= 2; ++level) (void)pipeline.step();
  EXPECT_EQ(modes, (std::vector{codec::DepthMode::Fast, codec::DepthMode::Intra, codec::DepthMode::Intra}));
  ASSERT_EQ(color_B.size(), 3u);
  EXPECT_LT(color_B[1], color_B[0]);
  EXPECT_LT(color_B[2], color_B[1]);
  for (level = 3; modes.size() < 6;) (void)pipeline.step();
  EXPECT_EQ(pipeline.frames(), 7u) << "at level 3, one of four images is left out";
  EXPECT_EQ(color_B.size(), 6u);
}

/// The colour messages of a pipeline: "J" a picture, "K" a key frame of video, "p" a predicted one.
struct ColorLog {
  std::string letters;
  bool drop_video = false;
  bool publish(const wire::Message& message) {
    if (message.topic.name == wire::kCameraColor.name) letters += 'J';
    if (message.topic.name != wire::kCameraColorVideo.name) return true;
    letters += message.key_frame ? 'K' : 'p';
    return !drop_video;
  }
};

TEST(CameraPipeline, EachCodingOfColourIsMadeOnlyWhileSomebodyTakesIt) {
  const wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  StillSource source(100, 0ms, clock);
  ColorLog log;
  pipeline::ColorWanted wanted{};
  pipeline::CameraPipeline pipeline(
      source, "still", {}, clock,
      {.publish = [&](const wire::Message& message, plan::Grade) { return log.publish(message); },
       .take_key_frame_request = [](std::string_view) { return false; },
       .wanted = [&] { return pipeline::Wanted{.color = wanted}; }});
  const auto after = [&](int images, pipeline::ColorWanted now) {
    wanted = now;
    log.letters.clear();
    for (int image = 0; image < images; ++image) (void)pipeline.step();
    return log.letters;
  };
  EXPECT_EQ(after(2, {.pictures = false, .video = false}), "JJ") << "pictures are ready for a newcomer";
  EXPECT_EQ(after(3, {.pictures = false, .video = true}), "Kpp");
  EXPECT_EQ(after(2, {.pictures = true, .video = true}), "pJpJ");
  EXPECT_EQ(after(2, {.pictures = true, .video = false}), "JJ");
  EXPECT_EQ(after(2, {.pictures = false, .video = true}), "Kp") << "a later subscriber begins with a key frame";
}

TEST(CameraPipeline, AKeyFrameOfVideoComesOnDemandAndAfterADroppedFrame) {
  const wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  StillSource source(100, 0ms, clock);
  ColorLog log;
  int requests = 0;
  pipeline::CameraPipeline pipeline(
      source, "still", {}, clock,
      {.publish = [&](const wire::Message& message, plan::Grade) { return log.publish(message); },
       .take_key_frame_request =
           [&](std::string_view topic) {
             return topic == wire::kCameraColorVideo.name && requests > 0 && requests-- > 0;
           },
       .wanted = [] { return pipeline::Wanted{.color = {.pictures = false, .video = true}}; }});
  const auto step = [&](int images) {
    for (int image = 0; image < images; ++image) (void)pipeline.step();
  };
  step(6);
  requests = 3;
  step(6);
  EXPECT_EQ(log.letters, "KpppppKpppKp") << "at most one of four frames is a requested key frame";
  log.letters.clear();
  log.drop_video = true;
  step(1);
  log.drop_video = false;
  step(2);
  EXPECT_EQ(log.letters.substr(1), "Kp") << "a dropped frame is no reference";
}

TEST(CameraPipeline, EachDepthImageIsAKeyFrameWhileALostOneCannotBeRepairedInTime) {
  const wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  StillSource source(30, 0ms, clock);
  std::vector<bool> is_key;
  bool may_predict = true;
  pipeline::CameraPipeline pipeline(source, "still", {.depth = {.mode = codec::DepthMode::Temporal, .key_every = 1000}},
                                    clock,
                                    {.publish =
                                         [&](const wire::Message& message, plan::Grade) {
                                           if (message.topic.name == wire::kCameraDepth.name)
                                             is_key.push_back(message.key_frame);
                                           return true;
                                         },
                                     .take_key_frame_request = [](std::string_view) { return false; },
                                     .may_predict = [&] { return may_predict; }});
  for (const bool predicts : {true, false, true}) {
    may_predict = predicts;
    for (int image = 0; image < 10; ++image) (void)pipeline.step();
  }
  ASSERT_EQ(is_key.size(), 30u);
  std::vector<bool> expected(30, false);
  expected[0] = true;
  std::fill(expected.begin() + 10, expected.begin() + 20, true);
  EXPECT_EQ(is_key, expected);
}

}  // namespace
}  // namespace telepalp::server
