#include <gtest/gtest.h>

#include "clients/view/live_figures.h"
#include "clients/view/newest_instant.h"
#include "codec/depth_stream.h"
#include "codec/video.h"
#include "server/pipeline/camera_messages.h"
#include "tests/server/still_source.h"

namespace telepalp::view {
namespace {

using Taken = NewestInstant::Taken;

constexpr std::int64_t kCaptured_ns = 5'000'000'000;

wire::Message depth_message(const RgbdFrame& frame, codec::DepthEncoder& encoder) {
  codec::EncodedDepth encoded = encoder.encode(frame.depth);
  const bool is_key = encoded.key_frame;
  return wire::make_message(wire::kCameraDepth, frame.captured, pipeline::depth_message(frame, std::move(encoded)),
                            is_key);
}

/// A state whose hand is `behind_ns` after the picture, half a metre before the camera.
wire::Message state_message(std::int64_t behind_ns) {
  msg::StationState state;
  state.set_stamp_ns(static_cast<std::uint64_t>(kCaptured_ns + behind_ns));
  state.mutable_device_camera()->set_z(0.5);
  return wire::make_message(wire::kStationState, session_time(kCaptured_ns + behind_ns), state);
}

struct Camera {
  RgbdFrame frame = server::small_frame(1, session_time(kCaptured_ns));
  codec::DepthEncoder encoder{{.mode = codec::DepthMode::Temporal, .key_every = 12}};
  wire::Message depth = depth_message(frame, encoder);
  wire::Message color = wire::make_message(wire::kCameraColor, frame.captured, pipeline::color_message(frame, 85));
  wire::Message info = wire::make_message(wire::kCameraInfo, frame.captured, pipeline::calibration_message(frame));
};

TEST(NewestInstant, IsCompleteWithDepthColourAndCameraInAnyOrder) {
  const Camera camera;
  std::vector<const wire::Message*> messages{&camera.color, &camera.depth, &camera.info};
  std::sort(messages.begin(), messages.end());
  do {
    NewestInstant instant;
    for (const wire::Message* message : messages) {
      EXPECT_FALSE(instant.is_complete(false));
      EXPECT_EQ(instant.take(*message), Taken::Yes);
    }
    EXPECT_TRUE(instant.is_complete(false));
    EXPECT_FALSE(instant.is_complete(true)) << "there is no station";
    const ColorImage picture = instant.picture(160, 120);
    EXPECT_EQ(picture.width, 160);
    EXPECT_EQ(picture.rgb.size(), 3U * 160 * 120);
  } while (std::next_permutation(messages.begin(), messages.end()));
}

TEST(NewestInstant, DrawsOnlyAHandOfTheSameInstant) {
  const Camera camera;
  NewestInstant instant;
  for (const wire::Message* message : {&camera.color, &camera.depth, &camera.info}) (void)instant.take(*message);
  (void)instant.take(state_message(200'000'000));
  EXPECT_FALSE(instant.is_complete(true)) << "0.2 s after the picture";
  const ColorImage alone = instant.picture(320, 240);
  (void)instant.take(state_message(4'000'000));
  ASSERT_TRUE(instant.is_complete(true));
  EXPECT_NE(instant.picture(320, 240).rgb, alone.rgb) << "the hand is drawn";
}

TEST(NewestInstant, AsksForAKeyFrameWhereItCannotDecode) {
  Camera camera;
  const wire::Message second = depth_message(camera.frame, camera.encoder);
  NewestInstant instant;
  EXPECT_EQ(instant.take(second), Taken::NeedsKeyFrame) << "it joined after the key frame";
  EXPECT_EQ(instant.take(camera.depth), Taken::Yes);
  EXPECT_EQ(instant.take({wire::kServerStats, session_time(1), std::make_shared<const std::string>("x"), 0, true}),
            Taken::NotNeeded);
}

TEST(NewestInstant, TakesColourAsVideoFromItsKeyFrameOn) {
  const Camera camera;
  codec::ColorVideoEncoder encoder({});
  const auto video = [&](std::uint64_t number) {
    codec::EncodedVideo encoded = encoder.encode(camera.frame.color, session_time(kCaptured_ns));
    const bool is_key = encoded.key_frame;
    wire::Message message = wire::make_message(wire::kCameraColorVideo, camera.frame.captured,
                                               pipeline::video_message(camera.frame, std::move(encoded.bytes)), is_key);
    message.sequence = number;
    return message;
  };
  const wire::Message key = video(1);
  const wire::Message second = video(2);
  const wire::Message third = video(3);
  NewestInstant instant;
  EXPECT_EQ(instant.take(second), Taken::NeedsKeyFrame);
  EXPECT_EQ(instant.take(key), Taken::Yes);
  EXPECT_EQ(instant.take(third), Taken::NeedsKeyFrame) << "the second one was lost";
  (void)instant.take(camera.depth);
  (void)instant.take(camera.info);
  EXPECT_TRUE(instant.is_complete(false));
}

TEST(NewestInstant, AMessageThatIsCutShortIsSaidToBeUnreadable) {
  const Camera camera;
  NewestInstant instant;
  for (wire::Message message : {camera.depth, camera.color, camera.info, state_message(0)}) {
    const std::string whole = *message.payload;
    message.payload = std::make_shared<const std::string>(whole.substr(0, whole.size() - 2));
    EXPECT_EQ(instant.take(message), Taken::Unreadable) << message.topic.name;
  }
  foxglove::CompressedImage color = pipeline::color_message(camera.frame, 85);
  color.mutable_data()->resize(color.data().size() / 2);
  EXPECT_EQ(instant.take(wire::make_message(wire::kCameraColor, camera.frame.captured, color)), Taken::Unreadable);
}

TEST(NewestInstant, AnImpossibleCameraModelIsIgnored) {
  const Camera camera;
  NewestInstant instant;
  foxglove::CameraCalibration broken = pipeline::calibration_message(camera.frame);
  broken.set_k(0, 0.0);
  for (const wire::Message* message : {&camera.color, &camera.depth}) (void)instant.take(*message);
  (void)instant.take(wire::make_message(wire::kCameraInfo, camera.frame.captured, broken));
  EXPECT_FALSE(instant.is_complete(false));
}

TEST(LiveFigures, CountRatesBytesAgesAndLosses) {
  LiveFigures figures;
  for (int i = 0; i < 100; ++i)
    figures.add({wire::kClock, session_time(1'000'000LL * i), std::make_shared<const std::string>(50, 'x'), 0, true},
                session_time(1'000'000LL * i + (i < 50 ? 2'000'000 : 8'000'000)));
  const auto topics = figures.topics(10.0, {{wire::kClock.name, {.messages = 100, .missed = 7}}});
  ASSERT_EQ(topics.size(), 1U);
  EXPECT_DOUBLE_EQ(topics[0].per_s, 10.0);
  EXPECT_DOUBLE_EQ(topics[0].bytes_per_s, 500.0);
  EXPECT_NEAR(topics[0].age_p50_ms, 2.0, 1e-4);
  EXPECT_NEAR(topics[0].age_p99_ms, 8.0, 1e-4);
  EXPECT_EQ(topics[0].missed, 7U);
  EXPECT_NE(in_table(topics, 0.5).find("/clock"), std::string::npos);
  EXPECT_NE(in_json(topics, 10.0, 0.5).find("\"missed\": 7"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::view
