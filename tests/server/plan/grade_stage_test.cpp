// The images of one grade, as the plan says.

#include "server/pipeline/grade_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "messages/camera.pb.h"
#include "proto/link/datagram_link.h"
#include "proto/wire/camera/depth_window_message.h"
#include "server/pipeline/camera_pipeline.h"
#include "tests/server/still_source.h"

namespace telepalp::pipeline {
namespace {

using namespace std::chrono_literals;

constexpr DepthErrorBound kBound{.least_m = 0.002, .per_m = 0.006};
const DepthWindow kWindow{.exact = {.column = 16, .row = 12, .width = 24, .height = 16},
                          .near = kBound,
                          .border = {.least_m = 0.004, .per_m = 0.012}};

struct Image {
  std::string_view topic;
  msg::DepthImage message;
  codec::DecodedDepth decoded;
};

/// A stage and the depth images that it published.
struct Stage {
  wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  std::vector<Image> images;
  int pictures = 0;
  codec::DepthReader reader;
  GradeStage stage{{.depth = {.mode = codec::DepthMode::Fast}}, clock, [this](const wire::Message& message) {
                     take(message);
                     return true;
                   }};

  void take(const wire::Message& message) {
    if (message.topic.name == wire::kCameraColor.name) ++pictures;
    if (message.topic.name != wire::kCameraDepth.name && message.topic.name != wire::kCameraDepthWindow.name) return;
    Image image{.topic = message.topic.name, .message = {}, .decoded = {}};
    EXPECT_TRUE(image.message.ParseFromString(*message.payload));
    const auto decoded = reader.read(std::as_bytes(std::span(image.message.data())));
    ASSERT_TRUE(decoded);
    image.decoded = *decoded;
    images.push_back(std::move(image));
  }
  void run(int frames, const GradeWanted& wanted) {
    images.clear();
    pictures = 0;
    stage.want(wanted);
    for (int i = 0; i < frames; ++i) {
      const RgbdFrame frame = server::small_frame(1, session_time(i));
      stage.publish_depth(frame, static_cast<std::uint64_t>(i), kWindow);
      stage.publish_color(frame, static_cast<std::uint64_t>(i));
    }
  }
};

GradeWanted window(const plan::ImageSettings& settings) {
  return {.color = {.pictures = true, .video = false}, .depth = {.whole = false, .window = true}, .settings = settings};
}

TEST(GradeStage, TheWindowStaysExactWhateverIsGivenUpAroundIt) {
  Stage stage;
  const DepthImage truth = server::small_frame(1, {}).depth;
  stage.run(6, window({.outside_factor = 4.0, .outside_every = 3}));
  ASSERT_EQ(stage.images.size(), 6u);
  for (std::size_t i = 0; i < stage.images.size(); ++i) {
    SCOPED_TRACE(i);
    const codec::DecodedDepth& got = stage.images[i].decoded;
    ASSERT_TRUE(got.window);
    const bool is_renewed = i % 3 == 0;
    EXPECT_EQ(got.window->near.least_m, is_renewed ? 4.0 * kBound.least_m : 0.25);
    for (int row = 0; row < truth.height; ++row)
      for (int column = 0; column < truth.width; ++column) {
        const auto bound = bound_at(*got.window, truth.width, truth.height, column, row);
        const double off_m = std::abs(got.image.at(column, row) - truth.at(column, row)) * truth.unit_m;
        ASSERT_LE(off_m, bound ? bound->at(truth.at(column, row) * truth.unit_m) + 1e-9 : 0.0);
      }
  }
}

TEST(GradeStage, SendsTheSharesOfThePlan) {
  Stage stage;
  stage.run(60, window({.depth_share = 0.5, .color_share = 1.0 / 6.0}));
  EXPECT_EQ(stage.images.size(), 30u);
  EXPECT_EQ(stage.pictures, 10);
}

TEST(GradeStage, TheLevelForWholeImagesLeavesTheHandsWindowAlone) {
  Stage stage;
  GradeWanted wanted = window({.level = link::ContentLevel::kLast});
  wanted.depth.whole = true;
  stage.run(8, wanted);
  const auto made = [&](const wire::Topic& topic) {
    return std::ranges::count(stage.images, topic.name, &Image::topic);
  };
  EXPECT_EQ(made(wire::kCameraDepthWindow), 8);
  EXPECT_EQ(made(wire::kCameraDepth), 6) << "every fourth is left out";
  EXPECT_EQ(stage.pictures, 6);
}

TEST(GradeStage, WholeDepthOfAViewerIsWithinTheStatedBound) {
  Stage stage;
  const DepthImage truth = server::small_frame(1, {}).depth;
  stage.run(2, {.color = {.pictures = false, .video = false},
                .depth = {.whole = true, .window = false},
                .settings = {.level = 1, .whole_factor = 2.0}});
  ASSERT_EQ(stage.images.size(), 2u);
  ASSERT_TRUE(stage.images[0].message.has_bound());
  const DepthErrorBound bound{.least_m = stage.images[0].message.bound().least_m(),
                              .per_m = stage.images[0].message.bound().per_m()};
  EXPECT_EQ(bound.least_m, 2.0 * codec::kOneDisparityStep.least_m);
  for (std::size_t i = 0; i < truth.samples.size(); ++i)
    ASSERT_LE(std::abs(stage.images[0].decoded.image.samples[i] - truth.samples[i]) * truth.unit_m,
              bound.at(truth.samples[i] * truth.unit_m) + 1e-9);
}

TEST(GradeStage, DefaultSettingsAreTheServersOptions) {
  const EncodeOptions asked{.depth = {.mode = codec::DepthMode::Fast, .key_every = 7}, .jpeg_quality = 85};
  const EncodeOptions made = with(asked, {});
  EXPECT_EQ(made.depth.mode, asked.depth.mode);
  EXPECT_EQ(made.depth.key_every, 7);
  EXPECT_EQ(made.jpeg_quality, asked.jpeg_quality);
  EXPECT_EQ(made.video_kbit_per_s, asked.video_kbit_per_s);
}

TEST(CameraPipeline, EachGradeIsMadeOnceAndOnlyWhileSomebodyTakesIt) {
  const wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  server::StillSource source(100, 0ms, clock);
  std::string letters;  // F full, T touch, V view; upper case depth, lower case colour
  Wanted wanted;
  CameraPipeline pipeline(source, "still", {}, clock,
                          {.publish =
                               [&](const wire::Message& message, plan::Grade grade) {
                                 const char depth = "FTV"[plan::index_of(grade)];
                                 const char color = "ftv"[plan::index_of(grade)];
                                 if (message.topic.name == wire::kCameraDepth.name) letters += depth;
                                 if (message.topic.name == wire::kCameraColor.name) letters += color;
                                 return true;
                               },
                           .take_key_frame_request = [](std::string_view) { return false; },
                           .wanted = [&] { return wanted; }});
  const auto next = [&] {
    letters.clear();
    (void)pipeline.step();
    return letters;
  };
  const GradeWanted all{.color = {.pictures = true}, .depth = {.whole = true}, .settings = {}};
  EXPECT_EQ(next(), "Ff");
  wanted.touch = wanted.view = all;
  EXPECT_EQ(next(), "TFVtfv") << "the hand's depth comes first";
  wanted.depth.whole = wanted.color.pictures = false;
  EXPECT_EQ(next(), "TVtv") << "nobody takes Full";
  wanted.touch = wanted.view = {};
  EXPECT_EQ(next(), "Ff") << "ready for a newcomer";
}

}  // namespace
}  // namespace telepalp::pipeline
