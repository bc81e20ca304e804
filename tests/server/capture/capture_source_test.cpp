#include "server/capture/capture_source.h"

#include <gtest/gtest.h>

#include <algorithm>
namespace telepalp::server {
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

}  // namespace
}  // namespace telepalp::server
