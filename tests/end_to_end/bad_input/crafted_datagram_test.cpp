// A hostile patient's site that holds the session's keys: it seals bad datagrams for the real station, over a real UDP
// socket. Good images come over TCP meanwhile, and the station feels each of them.

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "codec/depth.h"
#include "proto/link/frames/frame_sender.h"
#include "proto/wire/datagram_message.h"
#include "server/pipeline/camera_messages.h"
#include "tests/end_to_end/bad_input/crafted_server.h"
#include "tests/end_to_end/bad_input/running_session.h"
#include "where.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;

/// A level surface at 0.8 m in front of a Kinect's camera.
RgbdFrame level_frame(std::uint64_t sequence, SessionTime captured) {
  RgbdFrame frame;
  frame.captured = captured;
  frame.sequence = sequence;
  frame.camera.depth = {.width = 320, .height = 240, .fx = 290.0, .fy = 290.0, .cx = 159.5, .cy = 119.5};
  frame.camera.color = frame.camera.depth;
  frame.depth = {.width = 320, .height = 240, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(320 * 240, 800)};
  return frame;
}

/// The crafted server and the real station, for all tests of this file.
struct HostileSite {
  boost::asio::io_context io;
  CraftedServer server{io};
  support::TemporaryFolder folder;
  support::ChildProcess station{
      TELEPALP_BINARY_DIR "/bin/telepalp-station",
      {"--connect", "127.0.0.1:" + std::to_string(server.port()), "--patience", "60", "--control",
       (folder.path() / "control").string(), "--state-dir", (folder.path() / "state").string()},
      folder.path() / "station.log"};
  std::uint64_t images = 0;

  msg::DepthImage depth() {
    const RgbdFrame frame = level_frame(++images, server.now());
    codec::EncodedDepth encoded;
    encoded.bytes = codec::encode_depth(frame.depth);
    msg::DepthImage message = pipeline::depth_message(frame, std::move(encoded));
    message.set_encoded_ns(message.captured_ns());
    return message;
  }
  /// For 33 ms the network runs. A good image goes to the station first, over TCP.
  void step() {
    if (images % 30 == 0)
      server.publish(wire::kCameraInfo, pipeline::calibration_message(level_frame(0, server.now())));
    server.publish(wire::kCameraDepth, depth());
    io.run_for(33ms);
  }
  /// True if `more` further images become touchable while `attack` runs in each step, within 20 s.
  bool feels(std::size_t more, const std::function<void()>& attack) {
    const std::size_t before = server.surfaces();
    for (int i = 0; i < 600 && server.surfaces() < before + more; ++i) {
      attack();
      step();
    }
    return server.surfaces() >= before + more;
  }
  /// True if the station's log has `words` within 20 s of good images.
  bool says(const std::string& words) {
    for (int i = 0; i < 600 && log().find(words) == std::string::npos; ++i) step();
    return log().find(words) != std::string::npos;
  }
  [[nodiscard]] std::string log() const { return text_of(folder.path() / "station.log"); }
};

class CraftedTest : public ::testing::Test {
 protected:
  static HostileSite& site() { return SharedByTests<HostileSite>::get(); }
  void SetUp() override {
    ASSERT_TRUE(site().feels(10, [] {})) << site().log();
    ASSERT_TRUE(site().server.knows_station());
    before_MiB_ = most_resident_MiB(site().station.pid());
  }
  /// The station has grown by less than 100 MiB, lives, and has the session still.
  void TearDown() override {
    EXPECT_LT(most_resident_MiB(site().station.pid()), before_MiB_ + 100.0);
    EXPECT_GT(most_resident_MiB(site().station.pid()), 0.0) << site().log();
    EXPECT_EQ(site().server.closed(), "") << site().log();
    EXPECT_EQ(site().log().find("fault:"), std::string::npos) << site().log();
  }
  /// The payloads of an image of the patient as good datagrams.
  static std::vector<std::vector<std::byte>> good_payloads() {
    const wire::Message message{wire::kCameraDepth, site().server.now(),
                                std::make_shared<const std::string>(site().depth().SerializeAsString()),
                                site().server.next_sequence(wire::kCameraDepth), true};
    link::FrameSender sender(100ms);
    link::PathEstimate path;
    sender.offer(wire::frame_of(message, site().server.now()));
    std::vector<std::vector<std::byte>> payloads;
    while (const auto payload = sender.next(site().server.now(), path)) payloads.push_back(payload->joined());
    return payloads;
  }

 private:
  double before_MiB_ = 0.0;
};

class BadInput19 : public CraftedTest {};
TEST_F(BadInput19, AKeyIsChangedManyTimesAndImagesByDatagramStayTouchable) {
  const std::size_t before = site().server.surfaces();
  std::size_t sent = 0;
  for (int image = 0; image < 300 && site().server.surfaces() < before + 60; ++image) {
    for (const auto& payload : good_payloads()) {
      site().server.seal_and_send(payload);
      ++sent;
    }
    site().io.run_for(33ms);
  }
  EXPECT_GE(site().server.surfaces(), before + 60) << site().log();
  EXPECT_GT(sent, 3 * CraftedServer::kPacketsPerKey) << "at least three changes";
}

class BadInput20 : public CraftedTest {};
TEST_F(BadInput20, FirstFragmentsAloneTakeBoundedMemoryAndTheGoodImagesAreFelt) {
  std::uint32_t number = 0;
  EXPECT_TRUE(site().feels(60, [&] {
    for (int i = 0; i < 100; ++i) {
      std::vector<std::byte> payload(link::kFragmentHeaderBytes + link::FrameLayout(link::kMostFrameBytes).shard_bytes);
      link::write_fragment_header(
          {.channel = static_cast<std::uint8_t>(++number % link::kMostChannels),
           .frame = number,
           .frame_bytes = link::kMostFrameBytes},
          std::span<std::byte, link::kFragmentHeaderBytes>(payload.data(), link::kFragmentHeaderBytes));
      site().server.seal_and_send(payload);
    }
  })) << site().log();
  EXPECT_GT(number, 1000U);
}

class BadInput21 : public CraftedTest {};
TEST_F(BadInput21, FragmentsWithWrongNumbersAreRefusedAndTheGoodImagesAreFelt) {
  std::mt19937 random(21);
  std::size_t sent = 0;
  EXPECT_TRUE(site().feels(60,
                           [&] {
                             std::vector<std::byte> good = good_payloads().front();
                             for (int i = 0; i < 100; ++i) {
                               std::vector<std::byte> bad = good;
                               // Kind, channel, flags, sizes, block, number in the block, repairs: each is wrong in its
                               // turn.
                               bad[random() % link::kFragmentHeaderBytes] ^= static_cast<std::byte>(1 + random() % 255);
                               if (random() % 4 == 0) bad.resize(random() % (bad.size() + 1));
                               site().server.seal_and_send(bad);
                               ++sent;
                             }
                           }))
      << "seed 21: " << site().log();
  EXPECT_GT(sent, 1000U);
}

TEST_F(CraftedTest, WhatIsNotSealedOrOfAnotherSessionIsIgnoredByTheStation) {
  std::mt19937 random(15);
  EXPECT_TRUE(site().feels(30,
                           [&] {
                             for (int i = 0; i < 50; ++i) {
                               std::vector<std::byte> garbage(1 + random() % 1400);
                               for (std::byte& byte : garbage) byte = static_cast<std::byte>(random());
                               garbage.front() = std::byte{1};  // the version of sealed datagrams
                               site().server.send(garbage);
                             }
                           }))
      << "seed 15: " << site().log();
}

// The last test of this file: the datagrams of a connection end when the server's clock steps back, and TCP goes on.
class BadInput29 : public CraftedTest {};
TEST_F(BadInput29, AServersSessionClockThatStepsAnHourIsFollowedAndTheImagesAreFelt) {
  for (const auto& [by, said] :
       {std::pair(Nanoseconds(2h), "stepped by +7200.0 s"), std::pair(Nanoseconds(-3h), "stepped by -10800.0 s")}) {
    site().server.step_clock(by);
    EXPECT_TRUE(site().says(said)) << site().log();
    EXPECT_TRUE(site().feels(20, [] {})) << said << ": " << site().log();
    EXPECT_LT(std::chrono::abs(site().server.last_surface_age()), 20s) << "an age by the new clock";
  }
}

}  // namespace
}  // namespace telepalp::bad_input
