// telepalp-export: what it writes is read again by telepalp's own readers and holds the recorded numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "server/capture/open_recording.h"
#include "support/models/point_model.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/child_process.h"
#include "tools/export_tool/cloud_file.h"
#include "tools/export_tool/foxglove_session.h"
#include "tools/export_tool/frames.h"
#include "tools/export_tool/image_folder.h"
#include "tools/export_tool/message_table.h"
#include "where.h"

namespace telepalp::export_tool {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;
constexpr std::int64_t kFrame_ns = 33'333'333;
constexpr int kFrames = 20;

DepthImage depth_image(int frame) {
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24)};
  for (std::size_t place = 0; place < image.samples.size(); ++place)
    image.samples[place] =
        place % 7 == 0 ? 0 : static_cast<std::uint16_t>(700 + place % 32 + static_cast<unsigned>(frame));
  return image;
}

foxglove::CameraCalibration model() {
  foxglove::CameraCalibration model;
  model.set_frame_id("camera_depth");
  model.set_width(32);
  model.set_height(24);
  for (const double k : {30.0, 0.0, 15.5, 0.0, 30.0, 11.5, 0.0, 0.0, 1.0}) model.add_k(k);
  return model;
}

class Export : public testing::Test {
 protected:
  std::filesystem::path in(const std::string& name) const { return folder_.path() / name; }

  /// Depth in groups of eight, red colour that is registered to it, a station's state with a force.
  void SetUp() override {
    codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 8});
    ColorImage red{.width = 32, .height = 24, .rgb = std::vector<std::uint8_t>(32 * 24 * 3)};
    for (std::size_t place = 0; place < red.rgb.size(); place += 3) red.rgb[place] = 200;
    std::vector<wire::Message> messages{wire::make_message(wire::kCameraInfo, session_time(kStart_ns), model())};
    for (int frame = 0; frame < kFrames; ++frame) {
      const std::int64_t now = kStart_ns + frame * kFrame_ns;
      msg::DepthImage depth;
      depth.set_captured_ns(static_cast<std::uint64_t>(now));
      depth.set_data(encoder.encode(depth_image(frame)).bytes);
      messages.push_back(wire::make_message(wire::kCameraDepth, session_time(now), depth));
      foxglove::CompressedImage color;
      color.mutable_timestamp()->set_seconds(now / 1'000'000'000);
      color.mutable_timestamp()->set_nanos(static_cast<std::int32_t>(now % 1'000'000'000));
      color.set_frame_id("camera_depth");
      color.set_data(codec::encode_color(red, 90));
      messages.push_back(wire::make_message(wire::kCameraColor, session_time(now), color));
      msg::StationState state;
      state.set_stamp_ns(static_cast<std::uint64_t>(now));
      state.set_phase(msg::PHASE_IN_BODY);
      state.mutable_force_n()->set_y(0.25 * frame);
      messages.push_back(wire::make_message(wire::kStationState, session_time(now), state));
    }
    ASSERT_TRUE(wire::samples::write_file(in("session.mcap"), messages));
  }
  support::TemporaryFolder folder_;
};

TEST_F(Export, TheFrameAtATimeIsTheLastOneUpToItAndExact) {
  auto frames = Frames::open(in("session.mcap"));
  ASSERT_TRUE(frames);
  const auto frame = frames->at(0.45);  // frame 13 was published at 0.433 s, in the midst of a group
  ASSERT_TRUE(frame) << to_string(frame.error());
  EXPECT_EQ(frame->depth.samples, depth_image(13).samples);
  EXPECT_EQ(frame->color.width, 32);
}

TEST_F(Export, ACloudHoldsEachMeasuredPointWhereThePinholeSeesIt) {
  auto frames = Frames::open(in("session.mcap"));
  const auto frame = frames->at(0.0);
  ASSERT_TRUE(frame);
  const std::string ply = ply_of(*frame);
  const std::string pcd = pcd_of(*frame);
  const auto points = models::parse_ply(std::as_bytes(std::span(ply)), "a.ply");
  const auto organised = models::parse_pcd(std::as_bytes(std::span(pcd)), "a.pcd");
  ASSERT_TRUE(points) << to_string(points.error());
  ASSERT_TRUE(organised) << to_string(organised.error());
  EXPECT_EQ(organised->points.size(), 32u * 24u);
  EXPECT_EQ(organised->width, 32);
  EXPECT_EQ(points->points.size(), 32u * 24u - 110u) << "each seventh pixel is not measured";
  EXPECT_TRUE(std::isnan(organised->points[0].z()));
  const Eigen::Vector3f at = organised->points[32 * 5 + 9];
  EXPECT_NEAR(at.z(), depth_image(0).samples[32 * 5 + 9] * 0.001, 1e-6);
  EXPECT_NEAR(at.x(), (9 - 15.5) / 30.0 * static_cast<double>(at.z()), 1e-6);
  EXPECT_NEAR(at.y(), (5 - 11.5) / 30.0 * static_cast<double>(at.z()), 1e-6);
  ASSERT_EQ(organised->colors.size(), organised->points.size());
  EXPECT_NEAR(organised->colors[40][0], 200, 6);
}

TEST_F(Export, ImagesAreReadAgainAsASourceWithTheSameSamples) {
  const auto count = write_images(in("session.mcap"), in("images"));
  ASSERT_TRUE(count) << to_string(count.error());
  EXPECT_EQ(*count, static_cast<std::uint64_t>(kFrames));
  const auto source = capture::open_recording("images:" + in("images").string(), {.loop = false, .paced = false});
  ASSERT_TRUE(source) << to_string(source.error());
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto next = (*source)->next(1s);
    ASSERT_TRUE(next) << frame;
    EXPECT_EQ(next->depth.samples, depth_image(frame).samples);
    EXPECT_EQ(next->camera.depth.fx, 30.0);
    EXPECT_EQ(next->color.width, 32);
  }
  EXPECT_FALSE(write_images(in("session.mcap"), in("images"))) << "the folder is not empty";
}

TEST_F(Export, ATableHasALineForEachMessageAndForEachTickOfABatch) {
  const MessageTable states(wire::kStationState);
  msg::StationState state;
  state.set_phase(msg::PHASE_IN_BODY);
  state.mutable_force_n()->set_y(0.5);
  const std::string line = states.lines_of(wire::make_message(wire::kStationState, session_time(42), state));
  EXPECT_TRUE(line.starts_with("42,0,")) << line;
  EXPECT_NE(line.find("PHASE_IN_BODY"), std::string::npos);
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), [&] {
    const std::string header = states.header();
    return std::count(header.begin(), header.end(), ',');
  }());
  const MessageTable ticks(wire::kStationTicks);
  msg::StationTicks batch;
  for (const float force : {0.1F, 0.2F, 0.3F}) batch.add_force_x(force);
  const std::string lines = ticks.lines_of(wire::make_message(wire::kStationTicks, session_time(1), batch));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 3);
  EXPECT_TRUE(
      ticks.lines_of({wire::kStationTicks, session_time(1), std::make_shared<const std::string>("\xff")}).empty());
}

TEST_F(Export, AFoxgloveSessionHoldsItsOwnTypesAlone) {
  const auto count = write_foxglove(in("session.mcap"), in("foxglove.mcap"));
  ASSERT_TRUE(count) << to_string(count.error());
  auto reader = wire::McapReader::open(in("foxglove.mcap"));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->summary().statistics.message_count, *count);
  std::map<std::string, std::uint64_t> topics;
  for (const auto& [id, stored] : reader->summary().channels.all()) {
    EXPECT_TRUE(stored.schema->name.starts_with("foxglove.")) << stored.channel.topic;
    topics[stored.channel.topic] = reader->summary().statistics.channel_message_counts.at(id);
  }
  EXPECT_EQ(topics.at("/camera/points"), static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(topics.at("/camera/depth/image"), static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(topics.at("/station/scene"), static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(topics.at("/camera/color"), static_cast<std::uint64_t>(kFrames));
}

TEST_F(Export, OnAFullDiskNoFoxgloveSessionIsLeftBehind) {
  const std::string out = in("foxglove.mcap").string();
  const std::string command = "trap '' XFSZ; ulimit -f 2; exec " TELEPALP_BINARY_DIR "/bin/telepalp-export " +
                              in("session.mcap").string() + " --foxglove " + out + " 2> " + in("log").string();
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_NE(wire::samples::bytes_of(in("log")).find("cannot be written: File too large"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_FALSE(std::filesystem::exists(out + ".partial"));
}

TEST_F(Export, TheProgramWritesAndSaysWhatIsWrong) {
  const auto run = [&](std::vector<std::string> words) {
    support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-export", words, in("log"));
    return program.wait(20s).value_or(-1);
  };
  const std::string session = in("session.mcap").string();
  EXPECT_EQ(run({session, "--csv", "/station/state", "--out", in("state.csv")}), 0);
  const std::string csv = wire::samples::bytes_of(in("state.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), kFrames + 1);
  EXPECT_EQ(run({session, "--ply", "0.2", "--out", in("skin.ply")}), 0);
  EXPECT_TRUE(models::read_point_model(in("skin.ply")));
  EXPECT_EQ(run({session, "--ply", "900"}), 1);
  EXPECT_NE(wire::samples::bytes_of(in("log")).find("no depth image was published"), std::string::npos);
  EXPECT_EQ(run({session, "--csv", "/station/events", "--out", in("events.csv")}), 0);
  EXPECT_NE(wire::samples::bytes_of(in("log")).find("holds no message of /station/events"), std::string::npos);
  EXPECT_EQ(run({session, "--csv", "/no/topic"}), 2);
  EXPECT_EQ(run({session}), 2);
  EXPECT_EQ(run({session, "--ply", "1", "--pcd", "1"}), 2);
  EXPECT_EQ(run({in("none.mcap").string(), "--png", in("x")}), 1);
  ASSERT_TRUE(wire::samples::write_file(
      in("states.mcap"), {wire::make_message(wire::kStationState, session_time(kStart_ns), msg::StationState())}));
  EXPECT_EQ(run({in("states.mcap").string(), "--png", in("y")}), 1);
  EXPECT_FALSE(std::filesystem::exists(in("y"))) << "a second try finds no folder of the first";
  const std::string recorded = wire::samples::bytes_of(session);
  EXPECT_EQ(run({session, "--csv", "/station/state", "--out", folder_.path() / "." / "session.mcap"}), 2);
  EXPECT_NE(wire::samples::bytes_of(in("log")).find("is the session itself"), std::string::npos);
  EXPECT_EQ(wire::samples::bytes_of(session), recorded);
}

}  // namespace
}  // namespace telepalp::export_tool
