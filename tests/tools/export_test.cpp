// telepalp-export: what it writes is read again by telepalp's own readers and holds the recorded numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <random>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "codec/video.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedVideo.pb.h"
#include "foxglove/PointCloud.pb.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/color_message.h"
#include "server/capture/open_recording.h"
#include "support/models/point_model.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/child_process.h"
#include "tools/export_tool/cloud_file.h"
#include "tools/export_tool/foxglove_session.h"
#include "tools/export_tool/foxglove_size.h"
#include "tools/export_tool/frames.h"
#include "tools/export_tool/image_folder.h"
#include "tools/export_tool/message_table.h"
#include "where.h"

namespace telepalp::export_tool {
namespace {

using namespace std::chrono_literals;
using wire::samples::kFrame_ns;
using wire::samples::kStart_ns;

constexpr int kFrames = 20;

DepthImage depth_image(int frame, int width = 32, int height = 24) {
  DepthImage image{.width = width,
                   .height = height,
                   .unit_m = 0.001,
                   .samples = std::vector<std::uint16_t>(static_cast<std::size_t>(width * height))};
  std::mt19937 noise(static_cast<unsigned>(frame));
  for (std::size_t place = 0; place < image.samples.size(); ++place)
    image.samples[place] = place % 7 == 0 ? 0 : static_cast<std::uint16_t>(700 + place % 32 + noise() % 8);
  return image;
}

foxglove::CameraCalibration model(int width, int height) {
  foxglove::CameraCalibration model;
  model.set_frame_id("camera_depth");
  model.set_width(static_cast<std::uint32_t>(width));
  model.set_height(static_cast<std::uint32_t>(height));
  for (const double k : {30.0, 0.0, 15.5, 0.0, 30.0, 11.5, 0.0, 0.0, 1.0}) model.add_k(k);
  return model;
}

class Export : public testing::Test {
 protected:
  std::filesystem::path in(const std::string& name) const { return folder_.path() / name; }

  /// Depth in groups of eight, red colour that is registered to it, a station's state with a force.
  void SetUp() override { write_session("session.mcap", 32, 24); }
  void write_session(const std::string& name, int width, int height, Nanoseconds model_before = 0s) const {
    codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 8});
    ColorImage red{.width = width,
                   .height = height,
                   .rgb = std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 3))};
    for (std::size_t place = 0; place < red.rgb.size(); place += 3) red.rgb[place] = 200;
    std::vector<wire::Message> messages{
        wire::make_message(wire::kCameraInfo, session_time(kStart_ns - model_before.count()), model(width, height))};
    for (int frame = 0; frame < kFrames; ++frame) {
      const std::int64_t now = kStart_ns + frame * kFrame_ns;
      msg::DepthImage depth;
      depth.set_captured_ns(static_cast<std::uint64_t>(now));
      const codec::EncodedDepth encoded = encoder.encode(depth_image(frame, width, height));
      depth.set_data(encoded.bytes);
      messages.push_back(wire::make_message(wire::kCameraDepth, session_time(now), depth, encoded.key_frame));
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
    ASSERT_TRUE(wire::samples::write_file(in(name), messages));
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
  EXPECT_EQ(count->written, static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(count->left_out, 0u);
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
  const std::string line = *states.lines_of(wire::make_message(wire::kStationState, session_time(42), state));
  EXPECT_TRUE(line.starts_with("42,0,")) << line;
  EXPECT_NE(line.find("PHASE_IN_BODY"), std::string::npos);
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), [&] {
    const std::string header = states.header();
    return std::count(header.begin(), header.end(), ',');
  }());
  const MessageTable ticks(wire::kStationTicks);
  msg::StationTicks batch;
  for (const float force : {0.1F, 0.2F, 0.3F}) batch.add_force_x(force);
  const std::string lines = *ticks.lines_of(wire::make_message(wire::kStationTicks, session_time(1), batch));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 3);
  EXPECT_FALSE(
      ticks.lines_of({wire::kStationTicks, session_time(1), std::make_shared<const std::string>("\xff"), 0, true}));
}

TEST_F(Export, TruncatedMessagesAreLeftOutAndCounted) {
  auto reader = wire::McapReader::open(in("session.mcap"));
  ASSERT_TRUE(reader);
  std::vector<wire::Message> messages;
  while (const auto message = reader->next()) {
    if (!*message) break;
    messages.push_back(**message);
  }
  std::map<std::string_view, int> cut;
  for (wire::Message& message : messages) {
    if (message.published < session_time(kStart_ns + 3 * kFrame_ns) || ++cut[message.topic.name] > 1) continue;
    message.payload = std::make_shared<const std::string>(message.payload->substr(0, message.payload->size() - 3));
  }
  ASSERT_GE(cut.size(), 3u);
  ASSERT_TRUE(wire::samples::write_file(in("cut.mcap"), messages));
  const auto count = write_images(in("cut.mcap"), in("images"));
  ASSERT_TRUE(count) << to_string(count.error());
  EXPECT_GE(count->left_out, 2u) << "a depth image and a colour image";
  EXPECT_LT(count->written, static_cast<std::uint64_t>(kFrames));
  auto frames = Frames::open(in("cut.mcap"));
  ASSERT_TRUE(frames->at(0.1)) << "the frame before the damage";
  EXPECT_GE(frames->damaged(), 1u);
  const auto foxglove = write_foxglove(in("cut.mcap"), in("cut_foxglove.mcap"));
  ASSERT_TRUE(foxglove) << to_string(foxglove.error());
  EXPECT_GE(foxglove->left_out, 3u) << "a depth image, a colour image and a state";
  testing::internal::CaptureStderr();
  support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-export",
                                {in("cut.mcap"), "--csv", "/station/state", "--out", in("state.csv")});
  EXPECT_EQ(program.wait(20s), 0);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("1 damaged message or part of " + in("cut.mcap").string() + " is left out. fix: telepalp-record"),
            std::string::npos)
      << said;
}

/// Number of messages on each topic of a session.
std::map<std::string, std::uint64_t> topics_of(const wire::McapReader& reader) {
  std::map<std::string, std::uint64_t> topics;
  for (const auto& [id, stored] : reader.summary().channels.all())
    topics[stored.channel.topic] = reader.summary().statistics.channel_message_counts.at(id);
  return topics;
}

TEST_F(Export, AFoxgloveSessionHoldsFoxglovesTypesAndTheNumbersOfTheStation) {
  const auto count = write_foxglove(in("session.mcap"), in("foxglove.mcap"));
  ASSERT_TRUE(count) << to_string(count.error());
  auto reader = wire::McapReader::open(in("foxglove.mcap"));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->summary().statistics.message_count, count->written);
  EXPECT_EQ(count->left_out, 0u);
  for (const auto& [id, stored] : reader->summary().channels.all())
    EXPECT_TRUE(stored.schema->name.starts_with("foxglove.") || stored.channel.topic == "/station/state")
        << stored.channel.topic;
  const auto topics = topics_of(*reader);
  for (const char* topic :
       {"/camera/points", "/camera/depth/image", "/station/scene", "/station/phase", "/station/state", "/camera/color"})
    EXPECT_EQ(topics.at(topic), static_cast<std::uint64_t>(kFrames)) << topic;
  reader->select({.topics = {"/station/state"}});
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto message = reader->next();
    msg::StationState state;
    ASSERT_TRUE(message && *message && state.ParseFromString(*(*message)->payload));
    EXPECT_EQ(state.force_n().y(), 0.25 * frame);
  }
}

/// The session with its colour as video. `lost`: number of the frame that is left out.
void with_video(const std::string& from, const std::string& to, std::size_t lost) {
  codec::ColorVideoEncoder encoder({.kbit_per_s = 800, .key_every = 8});
  auto reader = wire::McapReader::open(from);
  ASSERT_TRUE(reader.ok());
  std::vector<wire::Message> messages;
  std::uint64_t number = 0;
  for (;;) {
    const auto message = reader->next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    const auto color = wire::compressed_color(**message);
    if (!color) {
      messages.push_back(**message);
      continue;
    }
    const auto image = codec::decode_color(std::as_bytes(std::span(color->data)));
    ASSERT_TRUE(image.ok());
    const codec::EncodedVideo encoded = encoder.encode(*image, session_time(color->captured_ns));
    foxglove::CompressedVideo video;
    wire::set_stamp(*video.mutable_timestamp(), session_time(color->captured_ns));
    video.set_frame_id(color->frame_id);
    video.set_format(codec::kVideoFormat);
    video.set_data(encoded.bytes);
    messages.push_back(wire::make_message(wire::kCameraColorVideo, (*message)->published, video, encoded.key_frame));
    messages.back().sequence = ++number;
    if (number == lost) messages.pop_back();
  }
  ASSERT_TRUE(wire::samples::write_file(to, messages));
}

TEST_F(Export, ColourAsVideoBecomesPicturesForFoxglove) {
  with_video(in("session.mcap"), in("video.mcap"), 0);
  const auto count = write_foxglove(in("video.mcap"), in("foxglove.mcap"));
  ASSERT_TRUE(count) << to_string(count.error());
  EXPECT_EQ(count->left_out, 0U);
  auto reader = wire::McapReader::open(in("foxglove.mcap"));
  ASSERT_TRUE(reader);
  EXPECT_EQ(topics_of(*reader).at("/camera/color"), static_cast<std::uint64_t>(kFrames));
  EXPECT_FALSE(topics_of(*reader).contains("/camera/color/video"));
  ASSERT_TRUE(write_foxglove(in("video.mcap"), in("rare.mcap"), {.station = false, .images_per_s = 10.0}));
  EXPECT_EQ(topics_of(*wire::McapReader::open(in("rare.mcap"))).at("/camera/color"), 7U);
}

TEST_F(Export, AFrameInTheMidstOfAGroupOfVideoHasItsColour) {
  with_video(in("session.mcap"), in("video.mcap"), 0);
  auto frames = Frames::open(in("video.mcap"));
  ASSERT_TRUE(frames);
  const auto frame = frames->at(0.45);
  ASSERT_TRUE(frame) << to_string(frame.error());
  ASSERT_EQ(frame->color.width, 32);
  EXPECT_NEAR(frame->color.rgb[0], 200, 8) << "red";
  EXPECT_LT(frame->color.rgb[1], 16) << "green";
}

TEST_F(Export, AfterALostFrameOfVideoNoPictureIsShownUntilTheNextKeyFrame) {
  with_video(in("session.mcap"), in("video.mcap"), 11);  // groups begin at 1, 9 and 17
  const auto count = write_foxglove(in("video.mcap"), in("foxglove.mcap"));
  ASSERT_TRUE(count);
  EXPECT_EQ(topics_of(*wire::McapReader::open(in("foxglove.mcap"))).at("/camera/color"), 14U);
  EXPECT_GE(count->left_out, 5U);
}

TEST_F(Export, TheCloudsOfAFoxgloveSessionAreColoured) {
  ASSERT_TRUE(write_foxglove(in("session.mcap"), in("foxglove.mcap")));
  auto reader = wire::McapReader::open(in("foxglove.mcap"));
  ASSERT_TRUE(reader);
  reader->select({.topics = {"/camera/points"}});
  const auto stored = reader->next_stored();
  foxglove::PointCloud cloud;
  ASSERT_TRUE(stored && *stored && cloud.ParseFromString(std::string((*stored)->record.data)));
  ASSERT_EQ(cloud.point_stride(), 16u);
  EXPECT_NEAR(static_cast<unsigned char>(cloud.data()[12]), 200, 6) << "red";
  EXPECT_LT(static_cast<unsigned char>(cloud.data()[13]), 10) << "green";
  EXPECT_EQ(static_cast<unsigned char>(cloud.data()[15]), 255) << "opaque";
}

TEST_F(Export, PartsAndRateChooseWhatAFoxgloveSessionHolds) {
  ASSERT_TRUE(write_foxglove(in("session.mcap"), in("a.mcap"), {.depth = false, .points = false}));
  const auto without = topics_of(*wire::McapReader::open(in("a.mcap")));
  EXPECT_FALSE(without.contains("/camera/points"));
  EXPECT_FALSE(without.contains("/camera/depth/image"));
  EXPECT_TRUE(without.contains("/station/state") && without.contains("/camera/color"));
  ASSERT_TRUE(write_foxglove(in("session.mcap"), in("b.mcap"), {.station = false, .images_per_s = 10.0}));
  const auto rare = topics_of(*wire::McapReader::open(in("b.mcap")));
  EXPECT_FALSE(rare.contains("/station/state"));
  EXPECT_EQ(rare.at("/camera/points"), 7u) << "20 frames are 0.63 s";
  EXPECT_EQ(rare.at("/camera/color"), 7u);
}

TEST_F(Export, TheSizeIsEstimatedWithinAFewPercent) {
  write_session("large.mcap", 320, 240);
  write_session("cut.mcap", 320, 240, 9s);  // a cut begins with a camera's model that is older than its images
  for (const char* session : {"large.mcap", "cut.mcap"})
    for (const FoxgloveParts& parts :
         {FoxgloveParts{}, FoxgloveParts{.points = false}, FoxgloveParts{.images_per_s = 10.0}}) {
      const auto size = estimated_size(in(session), parts);
      ASSERT_TRUE(size) << to_string(size.error());
      std::filesystem::remove(in("foxglove.mcap"));
      ASSERT_TRUE(write_foxglove(in(session), in("foxglove.mcap"), parts));
      const auto written = static_cast<double>(std::filesystem::file_size(in("foxglove.mcap")));
      EXPECT_NEAR(static_cast<double>(size->total()) / written, 1.0, 0.15) << session;
    }
}

TEST_F(Export, TheSizeIsAnnouncedBeforeTheFileIsWritten) {
  write_session("large.mcap", 320, 240);
  const std::string command = TELEPALP_BINARY_DIR "/bin/telepalp-export " + in("large.mcap").string() + " --foxglove " +
                              in("foxglove.mcap").string() + " 2> " + in("log").string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string said = wire::samples::bytes_of(in("log"));
  EXPECT_LT(said.find("foxglove.mcap will have about "), said.find("wrote ")) << said;
  EXPECT_NE(said.find("To write less: --parts color,station"), std::string::npos) << said;
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
  EXPECT_EQ(run({session, "--foxglove", in("f.mcap"), "--parts", "points,bones"}), 2);
  EXPECT_NE(wire::samples::bytes_of(in("log")).find("'bones' is not a part of a session"), std::string::npos);
  EXPECT_EQ(run({session, "--foxglove", in("f.mcap"), "--rate", "0"}), 2);
  EXPECT_EQ(run({session, "--png", in("p"), "--rate", "5"}), 2);
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
