// Depth for the hand: whose window the server follows, and the images that it makes for it.

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>

#include "codec/depth_stream.h"
#include "proto/wire/camera/depth_window_message.h"
#include "server/hub/upstream.h"
#include "server/pipeline/camera_pipeline.h"
#include "server/pipeline/window_choice.h"
#include "tests/codec/depth_frames.h"
#include "tests/codec/depth_windows.h"
#include "tests/server/still_source.h"

namespace telepalp {
namespace {

using namespace std::chrono_literals;
using server::StillSource;

constexpr SessionTime kStart{10s};
const DepthWindow kLeft = codec::window_around({0, 0, 20, 20}, codec::WindowGrowth::Flat);
const DepthWindow kRight = codec::window_around({40, 10, 20, 20}, codec::WindowGrowth::Growing);

TEST(WindowChoice, WithoutKeysTheFirstStationThatAsksIsFollowedUntilItIsSilent) {
  pipeline::WindowChoice choice(false);
  EXPECT_FALSE(choice.at(kStart));
  EXPECT_TRUE(choice.ask(1, kLeft, kStart));
  EXPECT_FALSE(choice.ask(2, kRight, kStart + 10ms));
  EXPECT_EQ(choice.at(kStart + 20ms), kLeft);
  EXPECT_TRUE(choice.ask(1, kRight, kStart + 900ms)) << "its hand moves";
  EXPECT_FALSE(choice.ask(2, kLeft, kStart + 1800ms));
  EXPECT_EQ(choice.at(kStart + 1899ms), kRight);
  EXPECT_FALSE(choice.at(kStart + 1900ms)) << "silent for 1 s: images are exact everywhere";
  EXPECT_TRUE(choice.ask(2, kLeft, kStart + 1900ms));
}

TEST(WindowChoice, WhereOnlyTheHolderOfTheTouchCanAskANewHolderIsFollowedAtOnce) {
  pipeline::WindowChoice choice(true);
  EXPECT_TRUE(choice.ask(1, kLeft, kStart));
  EXPECT_TRUE(choice.ask(2, kRight, kStart + 10ms));
  EXPECT_EQ(choice.at(kStart + 20ms), kRight);
}

msg::WindowRequest request_for(const DepthWindow& window) {
  msg::WindowRequest request;
  *request.mutable_window() = wire::to_message(window);
  return request;
}

bool passes(const msg::WindowRequest& request) {
  return hub::is_valid_upstream(wire::make_message(wire::kStationWindow, kStart, request));
}

TEST(WindowRequest, SurvivesTheWire) {
  EXPECT_EQ(wire::window_of(request_for(kRight).window()), kRight);
  EXPECT_TRUE(passes(request_for(kRight)));
}

TEST(WindowRequest, ThatNoImageCanHaveIsRefused) {
  constexpr int kMost = std::numeric_limits<int>::max();
  constexpr int kLeast = std::numeric_limits<int>::min();
  for (const PixelRect& exact : {PixelRect{-1, 0, 20, 20}, PixelRect{0, kLeast, 20, 20}, PixelRect{0, 0, 0, 20},
                                 PixelRect{0, 0, 20, -1}, PixelRect{kMost, kMost, kMost, kMost},
                                 PixelRect{kMaxImageSide, 0, 1, 1}, PixelRect{0, 0, kMaxImageSide + 1, 20}})
    EXPECT_FALSE(passes(request_for({.exact = exact, .near = kLeft.near, .border = kLeft.border}))) << exact.column;
  for (const double bound : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e-9,
                             1.001, kLeft.near.least_m / 2.0}) {
    msg::WindowRequest request = request_for(kLeft);
    request.mutable_window()->mutable_border()->set_least_m(bound);
    EXPECT_FALSE(passes(request)) << bound;
  }
  EXPECT_FALSE(passes({})) << "no window";
}

TEST(WindowRequest, AThousandASecondAreBoundedToAHundred) {
  hub::UpstreamRates rates;
  const wire::Message message = wire::make_message(wire::kStationWindow, kStart, request_for(kLeft));
  const auto begin = hub::RateLimiter::TimePoint{} + 1h;
  int passed = 0;
  for (int i = 0; i < 60'000; ++i) passed += rates.passes(message, begin + i * 1ms) ? 1 : 0;
  EXPECT_LE(passed, 512 + 60 * 100);
  EXPECT_GE(passed, 60 * 100);
}

/// The depth messages of a pipeline: "W" a whole image, "E" one of the window's topic that is exact everywhere, "w" one
/// with a window; a letter before "k" is a key frame.
struct DepthLog {
  std::string letters;
  std::optional<msg::DepthImage> newest;
  bool publish(const wire::Message& message) {
    const bool whole = message.topic.name == wire::kCameraDepth.name;
    if (!whole && message.topic.name != wire::kCameraDepthWindow.name) return true;
    newest.emplace();
    EXPECT_TRUE(newest->ParseFromString(*message.payload));
    letters += whole ? "W" : newest->has_window() ? "w" : "E";
    if (message.key_frame) letters += 'k';
    return true;
  }
};

TEST(CameraPipeline, DepthWithAWindowIsMadeOnlyWhileSomebodyTakesIt) {
  const wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  StillSource source(100, 0ms, clock);
  DepthLog log;
  pipeline::DepthWanted wanted{};
  std::optional<DepthWindow> window;
  pipeline::CameraPipeline pipeline(
      source, "still", {.depth = {.mode = codec::DepthMode::Temporal, .key_every = 99}}, clock,
      {.publish = [&](const wire::Message& message, plan::Grade) { return log.publish(message); },
       .take_key_frame_request = [](std::string_view) { return false; },
       .wanted = [&] { return pipeline::Wanted{.depth = wanted, .window = window}; }});
  const auto after = [&](int images, pipeline::DepthWanted now) {
    wanted = now;
    log.letters.clear();
    for (int image = 0; image < images; ++image) (void)pipeline.step();
    return log.letters;
  };
  EXPECT_EQ(after(2, {.whole = false, .window = false}), "WkW") << "ready for a newcomer";
  EXPECT_EQ(after(2, {.whole = false, .window = true}), "EkE") << "nobody has asked for a window";
  window = codec::window_around({0, 0, 2, 2}, codec::WindowGrowth::Flat);
  EXPECT_EQ(after(2, {.whole = true, .window = true}), "wWkwW")
      << "a recorder's images are exact, and begin with a key frame";
  EXPECT_EQ(wire::window_of(log.newest->window()), std::nullopt) << "the whole image has no window";
  window = codec::window_around({4000, 0, 2, 2}, codec::WindowGrowth::Flat);
  EXPECT_EQ(after(1, {.whole = false, .window = true}), "E") << "outside the image";
  EXPECT_EQ(after(1, {.whole = true, .window = false}), "Wk");
  EXPECT_EQ(after(1, {.whole = false, .window = true}), "Ek") << "a later subscriber begins with a key frame";
}

}  // namespace
}  // namespace telepalp
