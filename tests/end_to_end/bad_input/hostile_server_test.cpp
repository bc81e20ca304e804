// A hostile or broken patient's site: a server in this process sends bad images to the real station, over a real
// socket. The station drops and names each of them, stays small, and feels the patient again with the next good image.

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <numbers>
#include <thread>

#include "codec/depth.h"
#include "proto/wire/mcap/writer.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "server/pipeline/camera_messages.h"
#include "tests/end_to_end/bad_input/running_session.h"
#include "where.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// A level surface at 0.8 m in front of a Kinect's camera.
RgbdFrame good_frame(std::uint64_t sequence, SessionTime captured) {
  RgbdFrame frame;
  frame.captured = captured;
  frame.sequence = sequence;
  frame.camera.depth = {.width = 320, .height = 240, .fx = 290.0, .fy = 290.0, .cx = 159.5, .cy = 119.5};
  frame.camera.color = frame.camera.depth;
  frame.depth = {.width = 320, .height = 240, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(320 * 240, 800)};
  frame.color = {.width = 320, .height = 240, .rgb = std::vector<std::uint8_t>(3 * 320 * 240, 128)};
  return frame;
}

msg::DepthImage message_of(const RgbdFrame& frame) {
  codec::EncodedDepth encoded;
  encoded.bytes = codec::encode_depth(frame.depth);
  return pipeline::depth_message(frame, std::move(encoded));
}

class HostileServer : public ::testing::Test {
 protected:
  HostileServer()
      : station_(TELEPALP_BINARY_DIR "/bin/telepalp-station",
                 {"--connect", "127.0.0.1:" + std::to_string(site_.listener->port()), "--control",
                  (folder_.path() / "control").string(), "--state-dir", (folder_.path() / "state").string()},
                 log()),
        listener_(site_, {"/station/surface", "/station/state"}, "listener") {}

  [[nodiscard]] fs::path log() const { return folder_.path() / "station.log"; }

  void publish(const wire::Topic& topic, const google::protobuf::MessageLite& message) {
    site_.hub.publish(
        {topic, site_.clock.now(), std::make_shared<const std::string>(message.SerializeAsString()), 0, true});
  }
  msg::DepthImage good_depth() {
    const RgbdFrame frame = good_frame(++sequence_, site_.clock.now());
    msg::DepthImage message = message_of(frame);
    message.set_encoded_ns(message.captured_ns());
    return message;
  }
  /// Sends good images at 30 Hz until `count` of them became touchable, or for 10 s.
  bool feels_good_images(std::size_t count) {
    const std::size_t before = surfaces();
    for (int image = 0; image < 300 && surfaces() < before + count; ++image) {
      if (image % 30 == 0) publish(wire::kCameraInfo, pipeline::calibration_message(good_frame(0, site_.clock.now())));
      publish(wire::kCameraDepth, good_depth());
      (void)site_.run_until([] { return false; }, 33ms);
    }
    return surfaces() >= before + count;
  }
  [[nodiscard]] std::size_t surfaces() const {
    return static_cast<std::size_t>(
        std::count_if(listener_.messages.begin(), listener_.messages.end(),
                      [](const auto& m) { return m.topic.name == wire::kStationSurface.name; }));
  }
  /// Sends each image 30 times while the station feels the patient. Checks that it names the fault, stays small and
  /// continues.
  void expect_dropped(const msg::DepthImage& bad, const std::string& named) {
    ASSERT_TRUE(feels_good_images(10)) << text_of(log());
    const double before_MiB = most_resident_MiB(station_.pid());
    const std::size_t good = surfaces();
    for (int again = 0; again < 30; ++again) {
      publish(wire::kCameraDepth, bad);
      (void)site_.run_until([] { return false; }, 10ms);
    }
    EXPECT_TRUE(site_.run_until([&] { return text_of(log()).find(named) != std::string::npos; })) << text_of(log());
    EXPECT_LE(surfaces(), good + 2) << "an image that came before may still have been on its way";
    EXPECT_TRUE(feels_good_images(10)) << text_of(log());
    EXPECT_LT(most_resident_MiB(station_.pid()), before_MiB + 150.0);
    for (const wire::Message& message : listener_.messages) expect_sane_force(message);
  }
  static void expect_sane_force(const wire::Message& message) {
    if (message.topic.name != wire::kStationState.name) return;
    msg::StationState state;
    ASSERT_TRUE(state.ParseFromString(*message.payload));
    const double force_N = std::hypot(state.force_n().x(), state.force_n().y(), state.force_n().z());
    EXPECT_TRUE(std::isfinite(force_N) && force_N < 12.0) << force_N;
    EXPECT_NE(state.phase(), msg::PHASE_FAULTED);
  }

  server::Site site_;
  support::TemporaryFolder folder_;
  support::ChildProcess station_;
  server::Client listener_;
  std::uint64_t sequence_ = 0;
};

class BadInput01 : public HostileServer {};
TEST_F(BadInput01, ACompressedBombOfADepthImageIsRefused) {
  msg::DepthImage bomb = good_depth();
  DepthImage largest{.width = kMaxImageSide, .height = kMaxImageSide, .unit_m = 0.001, .samples = {}};
  largest.samples.assign(static_cast<std::size_t>(kMaxImageSide) * kMaxImageSide, 0);
  bomb.set_data(codec::encode_depth(largest, codec::DepthMode::Fast));
  ASSERT_LT(bomb.data().size(), 100'000U) << "a small packet that decodes to 32 MiB";
  expect_dropped(bomb, "depth image dropped");
}

class BadInput03 : public HostileServer {};
TEST_F(BadInput03, AZstdWindowOfTwoGibibytesIsRefused) {
  // A Zstandard frame header (RFC 8878, 3.1.1.1): no single segment, window exponent 21 above 2^10, and one raw block.
  msg::DepthImage window = good_depth();
  std::string data = window.data().substr(0, 24);
  data += std::string("\x28\xb5\x2f\xfd\x00\xa8\x01\x00\x00", 9);
  window.set_data(data);
  expect_dropped(window, "depth image dropped");
}

class BadInput08 : public HostileServer {};
TEST_F(BadInput08, ImageSizesThatOverflowOrDoNotFitAreRefused) {
  msg::DepthImage none = good_depth();
  none.set_width(0);
  expect_dropped(none, "depth image dropped");
  msg::DepthImage huge = good_depth();
  huge.set_width(std::numeric_limits<std::uint32_t>::max());
  huge.set_height(std::numeric_limits<std::uint32_t>::max());
  expect_dropped(huge, "depth image dropped");
  msg::DepthImage short_data = good_depth();
  short_data.set_data(short_data.data().substr(0, short_data.data().size() / 2));
  expect_dropped(short_data, "depth image dropped");
}

class BadInput09 : public HostileServer {};
TEST_F(BadInput09, IntrinsicsThatAreZeroOrNotFiniteAreRefused) {
  ASSERT_TRUE(feels_good_images(10)) << text_of(log());
  for (const double focal : {0.0, std::nan(""), std::numeric_limits<double>::infinity(), -290.0}) {
    foxglove::CameraCalibration bad = pipeline::calibration_message(good_frame(0, site_.clock.now()));
    bad.set_k(0, focal);
    bad.set_k(4, focal);
    for (int i = 0; i < bad.p_size(); ++i)
      if (bad.p(i) > 1.0) bad.set_p(i, focal);
    publish(wire::kCameraInfo, bad);
  }
  EXPECT_TRUE(site_.run_until([&] { return text_of(log()).find("/camera/info dropped") != std::string::npos; }))
      << text_of(log());
  wire::Message cut = wire::make_message(wire::kCameraInfo, site_.clock.now(),
                                         pipeline::calibration_message(good_frame(0, site_.clock.now())));
  cut.payload = std::make_shared<const std::string>(cut.payload->substr(0, cut.payload->size() - 5));
  site_.hub.publish(cut);
  EXPECT_TRUE(site_.run_until([&] {
    return text_of(log()).find("message dropped: /camera/info") != std::string::npos;
  })) << text_of(log());
  EXPECT_TRUE(feels_good_images(10)) << text_of(log());
  for (const wire::Message& message : listener_.messages) expect_sane_force(message);
}

/// A baseline JPEG's start up to its frame header, which claims `side` x `side` pixels in three components. `marker`:
/// 0xc0 baseline, 0xc2 progressive.
std::string jpeg_that_claims(int side, int marker) {
  std::string bytes("\xff\xd8\xff", 3);
  bytes += static_cast<char>(marker);
  bytes += std::string("\x00\x11\x08", 3);
  for (int twice = 0; twice < 2; ++twice) {
    bytes += static_cast<char>(side >> 8);
    bytes += static_cast<char>(side & 0xff);
  }
  return bytes + std::string("\x03\x01\x22\x00\x02\x11\x01\x03\x11\x01", 10) + std::string(480, '\0');
}

/// A session of good depth and of the picture `jpeg`; the report is made of it, and the server plays it.
void expect_session_is_survived(const std::string& jpeg) {
  const support::TemporaryFolder folder;
  const fs::path file = folder.path() / "session.mcap";
  {
    auto writer = wire::McapWriter::open(file, {});
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 60; ++i) {
      const SessionTime at = session_time(1'000'000'000 + 33'000'000LL * i);
      const RgbdFrame frame = good_frame(static_cast<std::uint64_t>(i), at);
      msg::DepthImage depth = message_of(frame);
      foxglove::CompressedImage color = pipeline::color_message(frame, 85);
      color.set_data(jpeg);
      ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraInfo, at, pipeline::calibration_message(frame))));
      ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraDepth, at, depth, true)));
      ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraColor, at, color)));
    }
    ASSERT_TRUE(writer->close());
  }
  support::ChildProcess report(TELEPALP_BINARY_DIR "/bin/telepalp-report",
                               {file.string(), "--out", (folder.path() / "report").string()},
                               folder.path() / "report.log");
  double report_MiB = 0.0;
  std::optional<int> ended;
  for (int i = 0; i < 600 && !ended; ++i) {
    ended = report.wait(50ms);
    report_MiB = std::max(report_MiB, most_resident_MiB(report.pid()));
  }
  ASSERT_TRUE(ended) << "the report takes more than half a minute";
  EXPECT_LT(*ended, 128) << "killed by a signal: " << text_of(folder.path() / "report.log");
  EXPECT_LT(report_MiB, 300.0);

  support::ChildProcess server(TELEPALP_BINARY_DIR "/bin/telepalp-server",
                               {"--source", "session:" + file.string(), "--port", "0", "--ready-file",
                                (folder.path() / "ready").string(), "--seconds", "3"},
                               folder.path() / "server.log");
  ASSERT_TRUE(support::await_ready(folder.path() / "ready", "port")) << text_of(folder.path() / "server.log");
  double server_MiB = 0.0;
  std::optional<int> server_ended;
  for (int i = 0; i < 200 && !server_ended; ++i) {
    server_MiB = std::max(server_MiB, most_resident_MiB(server.pid()));
    server_ended = server.wait(50ms);
  }
  EXPECT_EQ(server_ended, 0) << text_of(folder.path() / "server.log");
  EXPECT_LT(server_MiB, 200.0);
}

TEST(BadInput04, AJpegThatClaims20000PixelsASideIsRefusedBeforeItsMemory) {
  expect_session_is_survived(jpeg_that_claims(20'000, 0xc2));
  expect_session_is_survived(jpeg_that_claims(20'000, 0xc0));
}

TEST(BadInput05, ATruncatedJpegIsRefused) {
  const std::string whole = pipeline::color_message(good_frame(0, session_time(1)), 85).data();
  expect_session_is_survived(whole.substr(0, whole.size() / 2));
}

}  // namespace
}  // namespace telepalp::bad_input
