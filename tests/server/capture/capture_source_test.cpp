#include "server/capture/capture_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "codec/video.h"
#include "foxglove/CompressedVideo.pb.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/writer.h"
#include "server/capture/session/session_frames.h"
#include "server/pipeline/camera_messages.h"
#include "support/images/image_file.h"
#include "where.h"
namespace telepalp::capture {
namespace {

constexpr Nanoseconds kPatience{2'000'000'000};

SourceOptions options() { return {.clock = wire::SessionClock::anchored_to_wall_clock(), .loop = true, .paced = true}; }

std::string shipped(const std::string& name) { return TELEPALP_SOURCE_DIR "/deploy/demo_data/" + name; }

double valid_share(const DepthImage& depth) {
  const auto missing = std::count(depth.samples.begin(), depth.samples.end(), std::uint16_t{0});
  return 1.0 - static_cast<double>(missing) / static_cast<double>(depth.samples.size());
}

TEST(SyntheticSource, DeliversWellFormedFramesAtThirtyHertz) {
  const auto source = open_source("synthetic", options());
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  EXPECT_EQ((*source)->state(), CaptureState::Waiting);
  std::vector<RgbdFrame> frames;
  for (int i = 0; i < 4; ++i) {
    auto frame = (*source)->next(kPatience);
    ASSERT_TRUE(frame);
    EXPECT_TRUE(is_well_formed(*frame));
    EXPECT_LE(frame->captured, options().clock.now());
    frames.push_back(std::move(*frame));
  }
  EXPECT_EQ((*source)->state(), CaptureState::Live);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].sequence, frames[i - 1].sequence + 1);
    EXPECT_GE(frames[i].captured - frames[i - 1].captured, Nanoseconds{33'333'333});
  }
}

TEST(SyntheticSource, HalfTheExposureGivesHalfTheLightAndTheGainGivesItBack) {
  const auto source = open_source("synthetic", options());
  ASSERT_TRUE(source.ok());
  const auto brightness = [&] {
    const auto frame = (*source)->next(kPatience);
    double sum = 0.0;
    for (const std::uint8_t value : frame->color.rgb) sum += value;
    return sum / static_cast<double>(frame->color.rgb.size());
  };
  const double as_painted = brightness();
  const auto limits = (*source)->exposure_limits();
  ASSERT_TRUE(limits);
  const double exposure_ms = (*source)->exposure().exposure;
  ASSERT_TRUE((*source)->set_exposure({.automatic = false, .exposure = exposure_ms / 2, .gain = 1.0}));
  EXPECT_NEAR(brightness(), as_painted / 2, 0.6);
  ASSERT_TRUE((*source)->set_exposure({.automatic = false, .exposure = exposure_ms / 2, .gain = 2.0}));
  EXPECT_NEAR(brightness(), as_painted, 0.6);
  ASSERT_TRUE((*source)->set_exposure({.automatic = false, .exposure = limits->most, .gain = limits->most_gain}));
  EXPECT_GT(brightness(), 250.0) << "clipped";
  ASSERT_TRUE((*source)->set_exposure({.automatic = true}));
  EXPECT_NEAR(brightness(), as_painted, 0.6);
}

TEST(RecordedSource, HasNoExposureToSetAndSaysSo) {
  const auto source = open_source("oni:" + shipped("oni/3dj_test.oni"), options());
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  EXPECT_FALSE((*source)->exposure_limits());
  EXPECT_FALSE((*source)->set_exposure({.automatic = true}));
}

TEST(OniSource, PlaysARealRecordingWithColourAndStartsOver) {
  const auto source = open_source("oni:" + shipped("oni/3dj_test.oni"), options());
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  SessionTime last{};
  int with_color = 0;
  constexpr int kFrames = 30;  // the recording has 12
  for (int i = 0; i < kFrames; ++i) {
    const auto frame = (*source)->next(kPatience);
    ASSERT_TRUE(frame) << "frame " << i << ": " << (*source)->detail();
    EXPECT_TRUE(is_well_formed(*frame));
    EXPECT_EQ(frame->depth.width, 640);
    EXPECT_GT(valid_share(frame->depth), 0.6);
    EXPECT_FALSE(frame->camera.color_registered);
    EXPECT_NEAR(frame->camera.depth.fx, 575.8, 1.0);
    EXPECT_GT(frame->captured, last);
    last = frame->captured;
    with_color += frame->color.rgb.empty() ? 0 : 1;
  }
  EXPECT_GE(with_color, kFrames - 2);
}

TEST(OniSource, EndsWhereTheRecordingEndsWhenNotLooped) {
  SourceOptions once = options();
  once.loop = false;
  const auto source = open_source("oni:" + shipped("oni/3dj_test.oni"), once);
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  int frames = 0;
  for (int i = 0; i < 60 && (*source)->state() != CaptureState::Ended; ++i)
    if ((*source)->next(Nanoseconds{200'000'000})) ++frames;
  EXPECT_EQ((*source)->state(), CaptureState::Ended);
  EXPECT_GE(frames, 10);
  EXPECT_LE(frames, 12);
}

const std::string kData = TELEPALP_SOURCE_DIR "/tests/data/";

struct Played {
  std::optional<RgbdFrame> last;
  std::string detail;
};
Played play_some(const std::string& spec, int frames) {
  const auto source = open_source(spec, options());
  if (!source) return {std::nullopt, to_string(source.error())};
  Played played;
  for (int i = 0; i < frames; ++i) {
    played.last = (*source)->next(kPatience);
    if (!played.last) break;
    EXPECT_TRUE(is_well_formed(*played.last)) << spec;
  }
  played.detail = (*source)->detail();
  return played;
}

TEST(CameraSource, DriverPathWorksWithOpenNisOwnDummyDevice) {
  const Played played = play_some("openni2:Dummy", 5);
  ASSERT_TRUE(played.last) << played.detail;
  EXPECT_EQ(played.last->depth.width, 320);
  EXPECT_EQ(played.last->sequence, 4u);
}

TEST(CameraSource, IsClosedCleanlyBeforeItsFirstFrame) {
  for (int i = 0; i < 3; ++i) {
    const auto source = open_source("openni2:Dummy", options());
    ASSERT_TRUE(source.ok()) << to_string(source.error());
  }
}

TEST(ImagesSource, PlaysFoldersOfColourAndDepthAndLoops) {
  const Played played = play_some("images:" + kData + "images_rgb_depth", 5);
  ASSERT_TRUE(played.last) << played.detail;
  EXPECT_FALSE(played.last->color.rgb.empty());
  EXPECT_LE(*std::max_element(played.last->depth.samples.begin(), played.last->depth.samples.end()), 10'000);
  EXPECT_NE(played.detail.find("WARNING: no camera.textproto"), std::string::npos) << played.detail;
}

TEST(ImagesSource, PlaysTiffPairs) {
  const Played played = play_some("images:" + kData + "images_tiff_pairs", 3);
  ASSERT_TRUE(played.last) << played.detail;
  EXPECT_EQ(played.last->color.width, 640);
}

TEST(ImagesSource, TakesUnitAndIntrinsicsFromTheCameraFile) {
  const Played played = play_some("images:" + kData + "images_depth_only", 2);
  ASSERT_TRUE(played.last) << played.detail;
  EXPECT_EQ(played.last->depth.unit_m, 0.000125);
  EXPECT_EQ(played.last->camera.depth.fx, 476.007);
  EXPECT_EQ(played.detail.find("WARNING"), std::string::npos) << played.detail;
}

TEST(PcdSource, IsAStillCamera) {
  const Played played = play_some("pcd:" + kData + "pcd/person.pcd", 3);
  ASSERT_TRUE(played.last) << played.detail;
  EXPECT_EQ(played.last->sequence, 2u);
  EXPECT_NEAR(played.last->camera.depth.fx, 525.0, 0.5);
}

TEST(SyntheticSource, TakesItsSettingsFromTheCommandLine) {
  const Played exact = play_some("synthetic:torso,amplitude_mm=0,noise=none,steps=off,holes=off,unit_mm=0.1", 2);
  ASSERT_TRUE(exact.last) << exact.detail;
  EXPECT_EQ(exact.last->depth.unit_m, 0.0001);
  EXPECT_EQ(valid_share(exact.last->depth), 1.0);
}

TEST(SyntheticSource, ACameraWithFewerPixelsSeesTheSameAngles) {
  const Played whole = play_some("synthetic:torso", 1);
  const Played half = play_some("synthetic:torso,width=320", 1);
  ASSERT_TRUE(half.last) << half.detail;
  const Intrinsics& camera = half.last->camera.depth;
  EXPECT_EQ(camera.width, 320);
  EXPECT_EQ(camera.height, 240);
  EXPECT_EQ(half.last->depth.samples.size(), 320U * 240U);
  const Intrinsics& full = whole.last->camera.depth;
  EXPECT_DOUBLE_EQ((camera.cx + 0.5) / camera.fx, (full.cx + 0.5) / full.fx);     // same view to the left edge
  EXPECT_NEAR(half.last->depth.at(160, 120), whole.last->depth.at(320, 240), 8);  // two disparity steps [mm]
}

/// A folder for each test, removed at the end.
class SourceFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("telepalp_source_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

std::string bytes_in(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(SourceFolder, EachBadSourceIsNamedWithWhereAndFix) {
  write("hello.txt", "hello");
  write("cut.oni", bytes_in(shipped("oni/3dj_test.oni")).substr(0, 40));
  std::filesystem::create_directories(folder_ / "empty");
  std::filesystem::create_directories(folder_ / "gap");
  std::filesystem::create_directories(folder_ / "sizes");
  std::filesystem::create_directories(folder_ / "damaged");
  std::filesystem::create_directories(folder_ / "field");
  const std::string png = images::encode_png(images::GrayImage16{4, 2, std::vector<std::uint16_t>(8, 500)});
  for (const char* name : {"gap/1.png", "gap/2.png", "gap/4.png", "sizes/1.png", "damaged/1.png", "field/1.png"})
    write(name, png);
  write("sizes/2.png", images::encode_png(images::GrayImage16{2, 2, std::vector<std::uint16_t>(4, 500)}));
  write("damaged/2.png", png.substr(0, png.size() / 2));
  write("field/camera.textproto", "depth {\n  focal: 3\n}\n");
  const std::pair<std::string, std::string> kBad[] = {
      {"webcam", "'webcam' is not a kind of source"},
      {"oni:", "a file or folder must follow 'oni:'"},
      {"oni:" + file("no.oni"), "cannot be read"},
      {"oni:" + file("hello.txt"), "is not an .oni recording"},
      {"oni:" + file("cut.oni"), "cannot be played"},
      {"oni:" + folder_.string(), "is not an .oni recording"},
      {"pcd:" + file("no.pcd"), "cannot be read"},
      {"pcd:" + file("hello.txt"), "is not a supported kind of file"},
      {"pcd:" + kData + "pcd/milk_color.pcd", "is not organised"},
      {"images:" + file("no"), "cannot be listed"},
      {"images:" + file("hello.txt"), "cannot be listed"},
      {"images:" + file("empty"), "holds no depth images"},
      {"images:" + file("gap"), "3.png is missing"},
      {"images:" + file("sizes"), "is 2 x 2 pixels"},
      {"images:" + file("damaged"), "cannot be decoded"},
      {"images:" + file("field"), "focal"},
      {"synthetic:" + file("no.ply"), "cannot be read"},
      {"synthetic:" + file("hello.txt"), "is not a supported kind of file"},
      {"synthetic:torso,depth=3", "'depth' is not a setting"},
      {"synthetic:torso,amplitude_mm=500", "the value of amplitude_mm is not allowed"},
      {"synthetic:torso,noise=loud", "the value of noise is not allowed"},
      {"synthetic:torso,seed", "the value of seed is not allowed"},
      {"session:" + file("no.mcap"), "no.mcap"},
      {"session:" + file("hello.txt"), "hello.txt"},
  };
  for (const auto& [spec, says] : kBad) {
    const auto source = open_source(spec, options());
    ASSERT_FALSE(source.ok()) << spec;
    EXPECT_NE(to_string(source.error()).find(says), std::string::npos) << spec << " -> " << to_string(source.error());
    EXPECT_FALSE(source.error().where.empty()) << spec;
    EXPECT_FALSE(source.error().fix.empty()) << spec;
  }
}

TEST_F(SourceFolder, ColourMayBeJpegAndTheDescriptionSaysWhetherItIsRegistered) {
  const std::string depth = images::encode_png(images::GrayImage16{4, 2, std::vector<std::uint16_t>(8, 500)});
  const std::string color = codec::encode_color({8, 4, std::vector<std::uint8_t>(96, 200)});
  std::filesystem::create_directories(folder_ / "depth");
  std::filesystem::create_directories(folder_ / "rgb");
  for (const char* number : {"0001", "0002"}) {
    write("depth/" + std::string(number) + ".png", depth);
    write("rgb/" + std::string(number) + ".jpg", color);
  }
  const std::string camera =
      "depth { width: 4 height: 2 fx: 4 fy: 4 cx: 1.5 cy: 0.5 } color { width: 8 height: 4 fx: 8 fy: 8 cx: 3.5 cy: 1.5 "
      "} "
      "depth_unit_m: 0.001";
  for (const auto& [registered, says] : {std::pair{" color_registered: true", "with colour from"},
                                         std::pair{"", "with colour that is not registered to depth from"}}) {
    write("camera.textproto", camera + registered);
    const Played played = play_some("images:" + folder_.string(), 2);
    ASSERT_TRUE(played.last) << played.detail;
    EXPECT_EQ(played.last->color.width, 8);
    EXPECT_NEAR(played.last->color.rgb.front(), 200, 3);
    EXPECT_NE(played.detail.find(says), std::string::npos) << played.detail;
  }
  write("rgb/0002.jpg", color.substr(0, color.size() / 2));
  const auto cut = open_source("images:" + folder_.string(), options());
  ASSERT_FALSE(cut.ok());
  EXPECT_EQ(cut.error().where, file("rgb/0002.jpg"));
}

TEST_F(SourceFolder, ADamagedRecordingNeitherCrashesNorHangs) {
  std::string bytes = bytes_in(shipped("oni/3dj_test.oni"));
  write("half.oni", bytes.substr(0, bytes.size() / 2));
  SourceOptions once = options();
  once.loop = false;
  const auto source = open_source("oni:" + file("half.oni"), once);
  if (!source) return;  // the source may be refused, too
  for (int i = 0; i < 20; ++i) (void)(*source)->next(Nanoseconds{100'000'000});
}

/// Records the frames of a source as the server's messages.
void record(const std::string& spec, const std::string& to, int frames,
            const codec::DepthStreamSettings& depth = {.mode = codec::DepthMode::Fast}) {
  codec::DepthEncoder encoder(depth);
  auto source = open_source(spec, options());
  ASSERT_TRUE(source.ok());
  auto writer = wire::McapWriter::open(to, {});
  ASSERT_TRUE(writer.ok()) << to_string(writer.error());
  for (int i = 0; i < frames; ++i) {
    const auto frame = (*source)->next(kPatience);
    ASSERT_TRUE(frame);
    const SessionTime at = frame->captured;
    ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraInfo, at, pipeline::calibration_message(*frame))).ok());
    ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraColor, at, pipeline::color_message(*frame, 85))).ok());
    codec::EncodedDepth encoded = encoder.encode(frame->depth);
    const bool is_key = encoded.key_frame;
    const msg::DepthImage image = pipeline::depth_message(*frame, std::move(encoded));
    ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraDepth, at, image, is_key)).ok());
  }
  ASSERT_TRUE(writer->close().ok());
}

/// Replaces the pictures of a recorded session by video.
void with_video(const std::string& from, const std::string& to) {
  codec::ColorVideoEncoder encoder({});
  auto reader = wire::McapReader::open(from);
  auto writer = wire::McapWriter::open(to, {});
  ASSERT_TRUE(reader.ok() && writer.ok());
  for (;;) {
    const auto message = reader->next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    const auto color = wire::compressed_color(**message);
    if (!color) {
      ASSERT_TRUE(writer->write(**message).ok());
      continue;
    }
    const auto image = codec::decode_color(std::as_bytes(std::span(color->data)));
    ASSERT_TRUE(image.ok());
    const SessionTime captured = session_time(color->captured_ns);
    codec::EncodedVideo encoded = encoder.encode(*image, captured);
    foxglove::CompressedVideo video;
    wire::set_stamp(*video.mutable_timestamp(), captured);
    video.set_frame_id(color->frame_id);
    video.set_format(codec::kVideoFormat);
    video.set_data(encoded.bytes);
    ASSERT_TRUE(writer->write(wire::make_message(wire::kCameraColorVideo, captured, video, encoded.key_frame)).ok());
  }
  ASSERT_TRUE(writer->close().ok());
}

TEST_F(SourceFolder, ASessionWithColourAsVideoPlaysItsColour) {
  constexpr int kFrames = 6;
  record("synthetic:torso,rate_hz=0.25", file("run.mcap"), kFrames);
  with_video(file("run.mcap"), file("video.mcap"));
  auto pictures = SessionFrames::open(file("run.mcap"));
  auto video = SessionFrames::open(file("video.mcap"));
  ASSERT_TRUE(pictures.ok() && video.ok()) << to_string(video.error());
  for (int i = 0; i < kFrames; ++i) {
    ASSERT_TRUE(pictures->peek() && video->peek());
    const auto as_picture = pictures->take();
    if (i == 1) {
      video->skip();  // the next frame is predicted from it
      continue;
    }
    const auto as_video = video->take();
    ASSERT_TRUE(as_picture && as_video);
    ASSERT_EQ(as_video->color.rgb.size(), as_picture->color.rgb.size());
    double difference = 0.0;
    for (std::size_t at = 0; at < as_video->color.rgb.size(); ++at)
      difference += std::abs(int{as_video->color.rgb[at]} - int{as_picture->color.rgb[at]});
    EXPECT_LT(difference / static_cast<double>(as_video->color.rgb.size()), 6.0) << i;
  }
  EXPECT_EQ(video->damaged(), 0U);
}

TEST_F(SourceFolder, ARecordedSessionPlaysTheSameDepthAgainAtItsPace) {
  constexpr int kFrames = 6;
  record("synthetic:torso,rate_hz=0.25", file("run.mcap"), kFrames);
  auto first = SessionFrames::open(file("run.mcap"));
  ASSERT_TRUE(first.ok()) << to_string(first.error());
  SourceOptions once = options();
  once.loop = false;
  once.paced = false;  // a paced source drops frames that a busy machine fetches late
  const auto source = open_source("session:" + file("run.mcap"), once);
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  std::optional<SessionTime> then_before;
  std::optional<SessionTime> now_before;
  for (int i = 0; i < kFrames; ++i) {
    const auto then = first->peek();
    ASSERT_TRUE(then);
    const auto recorded = first->take();
    const auto played = (*source)->next(kPatience);
    ASSERT_TRUE(recorded && played) << (*source)->detail();
    EXPECT_EQ(played->depth.samples, recorded->depth.samples);
    EXPECT_EQ(played->color.width, 640);
    EXPECT_TRUE(played->camera.color_registered);
    EXPECT_EQ(played->camera.depth.fx, 525.0);
    if (then_before) {
      EXPECT_EQ(played->captured - *now_before, *then - *then_before);
    }
    then_before = then;
    now_before = played->captured;
  }
  EXPECT_FALSE((*source)->next(Nanoseconds{1'000'000}));
  EXPECT_EQ((*source)->state(), CaptureState::Ended);
}

TEST_F(SourceFolder, ARecordedSessionLoopsForward) {
  record("synthetic", file("run.mcap"), 3);
  const auto source = open_source("session:" + file("run.mcap"), options());
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  SessionTime last{};
  for (int i = 0; i < 8; ++i) {
    const auto frame = (*source)->next(kPatience);
    ASSERT_TRUE(frame);
    EXPECT_GT(frame->captured, last);
    last = frame->captured;
  }
}

TEST_F(SourceFolder, ASessionOfTemporalDepthGivesAnyFrameThoughOthersWerePassedOver) {
  constexpr int kFrames = 9;
  record("synthetic", file("run.mcap"), kFrames, {.mode = codec::DepthMode::Temporal, .key_every = 4});
  auto all = SessionFrames::open(file("run.mcap"));
  auto some = SessionFrames::open(file("run.mcap"));
  ASSERT_TRUE(all.ok() && some.ok());
  for (int i = 0; i < 2 * kFrames; ++i) {
    if (i == kFrames) {
      all->rewind();
      some->rewind();
    }
    ASSERT_TRUE(all->peek() && some->peek()) << i;
    const auto truth = all->take();
    if (i % 3 == 1) {
      some->skip();
      continue;
    }
    const auto frame = some->take();
    ASSERT_TRUE(truth && frame) << i;
    EXPECT_EQ(frame->depth.samples, truth->depth.samples) << i;
  }
  EXPECT_EQ(some->damaged(), 0u);
}

TEST_F(SourceFolder, ASessionOfBoundedDepthIsNotAsMeasuredHoweverItIsCompressedAgain) {
  const codec::DepthStreamSettings bounded{.mode = codec::DepthMode::Bounded,
                                           .bound = {.least_m = 0.001, .per_m = 0.003}};
  record("synthetic", file("bounded.mcap"), 2, bounded);
  record("session:" + file("bounded.mcap"), file("again.mcap"), 2);
  record("session:" + file("bounded.mcap"), file("twice.mcap"), 2, bounded);
  const auto loss_in = [&](const std::string& name) {
    auto frames = SessionFrames::open(file(name));
    EXPECT_TRUE(frames.ok());
    const auto frame = frames->peek() ? frames->take() : std::nullopt;
    return frame && frame->loss ? *frame->loss : DepthErrorBound{-1.0, -1.0};
  };
  EXPECT_EQ(loss_in("again.mcap").least_m, 0.001);
  EXPECT_EQ(loss_in("again.mcap").per_m, 0.003);
  EXPECT_EQ(loss_in("twice.mcap").least_m, 0.002);
  EXPECT_EQ(loss_in("twice.mcap").per_m, 0.006);
  record("synthetic", file("exact.mcap"), 2);
  EXPECT_EQ(loss_in("exact.mcap").least_m, -1.0) << "as measured";
}

TEST(DepthMessage, StatesThatTheErrorOfItsDepthIsUnknown) {
  RgbdFrame frame;
  frame.loss = DepthErrorBound::unknown();
  for (const codec::DepthMode mode : {codec::DepthMode::Fast, codec::DepthMode::Bounded}) {
    codec::EncodedDepth encoded;
    encoded.mode = mode;
    if (mode == codec::DepthMode::Bounded) encoded.bound = codec::kOneDisparityStep;
    const wire::DepthFidelity fidelity = wire::depth_fidelity(pipeline::depth_message(frame, encoded));
    EXPECT_TRUE(fidelity.moved);
    EXPECT_FALSE(fidelity.within);
  }
}

}  // namespace
}  // namespace telepalp::capture
