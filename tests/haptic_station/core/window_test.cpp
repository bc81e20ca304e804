// The window of exact depth that the station asks for, and the surface that it makes from images with a window.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptic_station/core/window/window_requests.h"
#include "proto/wire/camera/depth_window_message.h"
#include "tests/haptic_station/core/stream.h"

namespace telepalp::core {
namespace {

using namespace std::chrono_literals;

constexpr Intrinsics kVga{.width = 640, .height = 480, .fx = 575, .fy = 575, .cx = 319.5, .cy = 239.5};

Point<DepthCamera> at(double x, double y, double z) { return {{x, y, z}}; }

/// True if the window has the pixels that the surface at `place` needs.
bool has_support(const PixelRect& exact, const Eigen::Vector3d& place) { return covers(exact, {place}, kVga); }

TEST(HandWindow, HoldsTheHandWhereverItIsWhenTheImageComes) {
  for (const double speed : {0.0, 0.2, 1.0})
    for (const Nanoseconds lead : {20ms, 100ms, 200ms})
      for (const double angle : {0.0, 1.0, 2.5, 4.0, 5.5}) {
        const Eigen::Vector3d velocity = speed * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.3);
        const auto exact = hand_window({.device = at(0.02, -0.03, 0.8), .velocity_m_per_s = velocity}, lead, kVga);
        ASSERT_TRUE(exact);
        for (const double share : {0.0, 0.5, 1.0, 1.7}) {  // it stops at once, slows down, goes on, goes faster
          const Eigen::Vector3d place = Eigen::Vector3d(0.02, -0.03, 0.8) + share * to_seconds(lead) * velocity;
          EXPECT_TRUE(has_support(*exact, place)) << speed << " m/s, " << share;
        }
      }
}

TEST(HandWindow, IsAboutASeventhOfTheImageForASlowHandOverA100msPath) {
  const auto exact = hand_window({.device = at(0.0, 0.0, 0.8), .velocity_m_per_s = {0.3, 0.0, 0.0}}, 150ms, kVga);
  ASSERT_TRUE(exact);
  const double share = static_cast<double>(exact->width) * exact->height / (640.0 * 480.0);
  EXPECT_GT(share, 0.05);
  EXPECT_LT(share, 0.15);
  EXPECT_EQ(exact->height % 4, 0);
}

TEST(HandWindow, StaysInTheImageWhateverTheHandDoes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(hand_window({.device = at(nan, 0.0, 0.8)}, 100ms, kVga));
  EXPECT_FALSE(hand_window({.device = at(0.0, 0.0, 0.8), .velocity_m_per_s = {infinite, 0.0, 0.0}}, 100ms, kVga));
  EXPECT_FALSE(hand_window({.device = at(0.0, 0.0, -0.8)}, 100ms, kVga)) << "behind the camera";
  EXPECT_FALSE(hand_window({.device = at(5.0, 0.0, 0.8)}, 100ms, kVga)) << "beside the image";
  EXPECT_FALSE(hand_window({.device = at(1e300, 0.0, 0.8)}, 100ms, kVga));
  for (const double x : {-0.45, 0.45})
    for (const double y : {-0.33, 0.33})
      for (const double speed : {0.0, 2.0, 1e6}) {
        const auto exact =
            hand_window({.device = at(x, y, 0.8), .velocity_m_per_s = {-speed * x, -speed * y, 0.0}}, 100ms, kVga);
        EXPECT_TRUE(exact || speed > 2.0);
        if (!exact) continue;
        EXPECT_EQ(clipped(*exact, 640, 480), *exact) << x << ", " << y << ", " << speed;
      }
  const Intrinsics low{.width = 640, .height = 2, .fx = 575, .fy = 575, .cx = 319.5, .cy = 0.5};
  EXPECT_EQ(hand_window({.device = at(0.0, 0.0, 0.8)}, 100ms, low)->height, 2);
}

loop::TickSample tick_at(std::int64_t stamp_ns, float x) {
  loop::TickSample tick;
  tick.stamp_ns = stamp_ns;
  tick.hand = tick.device = tick.device_camera = {x, 0.0F, 0.8F};
  tick.surface_age_s = 0.1F;
  return tick;
}

TEST(WindowRequests, ComeThirtyTimesASecondAndLookAheadOfTheHand) {
  WindowRequests requests;
  int sent = 0;
  PixelRect last;
  for (int tick = 0; tick < 2000; ++tick) {  // 1 s at 0.5 m/s
    const float x = -0.25F + 0.00025F * static_cast<float>(tick);
    const auto request = requests.due(tick_at(tick * 500'000LL, x), {}, kVga);
    if (!request) continue;
    ++sent;
    last = wire::window_of(request->window())->exact;
  }
  EXPECT_GE(sent, 28);
  EXPECT_LE(sent, 31);
  const double device_u = 575 * 0.25 / 0.8 + 319.5;
  EXPECT_GT(last.column + last.width / 2.0, device_u) << "the middle of the window is ahead of the hand";
}

TEST(WindowRequests, GoOnAfterTheClockSteppedBack) {
  WindowRequests requests;
  EXPECT_TRUE(requests.due(tick_at(10'000'000'000, 0.0F), {}, kVga));
  EXPECT_TRUE(requests.due(tick_at(1'000'000'000, 0.0F), {}, kVga));
}

TEST(WindowRequests, SayOnceThatTheHandHasLeftTheWindow) {
  WindowRequests requests;
  msg::SurfaceReport inside;
  msg::SurfaceReport outside;
  outside.set_hand_outside_window(true);
  const SessionTime start = kFirstImage;
  EXPECT_FALSE(requests.look(inside, start));
  EXPECT_TRUE(requests.look(outside, start + 100ms));
  EXPECT_FALSE(requests.look(outside, start + 200ms));
  EXPECT_FALSE(requests.look(inside, start + 300ms));
  EXPECT_FALSE(requests.look(outside, start + 400ms)) << "said less than 5 s ago";
  EXPECT_FALSE(requests.look(inside, start + 500ms));
  EXPECT_TRUE(requests.look(outside, start + 6s));
}

/// An image of a patient with rough skin. `exact`: the image is coded with this window, and is up to 8 mm off
/// elsewhere.
ArrivedDepth rough_image(const std::optional<PixelRect>& exact) {
  DepthImage depth = level_patient(0);
  for (std::size_t i = 0; i < depth.samples.size(); ++i)
    depth.samples[i] = static_cast<std::uint16_t>(880 + 7 * i % 11 + i / kWidth / 4);
  std::optional<DepthWindow> window;
  if (exact) window = codec::window_around(*exact, codec::WindowGrowth::Growing);
  ArrivedDepth arrived = stream_of(codec::DepthMode::Intra, 1, 1).back();
  msg::DepthImage message;
  message.ParseFromString(*arrived.depth.payload);
  message.set_data(codec::DepthEncoder({.mode = codec::DepthMode::Intra}).encode(depth, window).bytes);
  arrived.depth = wire::make_message(wire::kCameraDepthWindow, arrived.depth.published, message, true);
  return arrived;
}

SurfaceStage::Result touched(SurfaceStage& stage, const ArrivedDepth& image, const Point<HapticBase>& device) {
  (void)stage.admit(image.depth.payload->size());
  stage.arrived(image);
  const auto job = stage.take(image.received, device);
  return stage.run(*job, [&](StageStep) { return image.received; });
}

TEST(SurfaceStage, MakesTheSameSurfaceInTheWindowAsWithoutOne) {
  const Point<HapticBase> kDevice{{0.0, 0.0, 0.9}};
  const PixelRect middle{52, 32, 56, 56};
  SurfaceStage with_window = fast_stage();
  SurfaceStage without_window = fast_stage();
  const auto result = touched(with_window, rough_image(middle), kDevice);
  const auto whole = touched(without_window, rough_image(std::nullopt), kDevice);
  ASSERT_TRUE(result.surface && whole.surface);
  EXPECT_FALSE(result.report.hand_outside_window());
  EXPECT_EQ(wire::window_of(result.report.window())->exact, middle);
  for (const double x : {-0.02, -0.01, 0.0, 0.01, 0.02}) {
    const auto f_m = [&](const SurfaceStage::Result& made) {
      return made.surface->snapshot->evaluate({x, 0.5 * x, 0.89}, {0.0, 0.0, -1.0}, {}).f_m;
    };
    EXPECT_NEAR(f_m(result), f_m(whole), 1e-9) << "at " << x << ": but for rounding, as sums begin at another pixel";
  }
}

TEST(SurfaceStage, MakesNoSurfaceFromDepthThatIsNotExactAndSaysThatTheHandIsThere) {
  SurfaceStage stage = fast_stage();
  const auto narrow = touched(stage, rough_image(PixelRect{68, 48, 24, 24}), {{0.0, 0.0, 0.9}});
  EXPECT_TRUE(narrow.report.hand_outside_window()) << "it depends on more pixels than these";
  ASSERT_TRUE(narrow.surface);
  EXPECT_LE(narrow.surface->snapshot->points, 24U * 24U);
  SurfaceStage whole = fast_stage();
  const auto all = touched(whole, rough_image(std::nullopt), {{0.0, 0.0, 0.9}});
  EXPECT_GT(all.surface->snapshot->points, 24U * 24U) << "else the limit above means nothing";
  SurfaceStage far = fast_stage();
  EXPECT_TRUE(touched(far, rough_image(PixelRect{0, 0, 40, 40}), {{0.1, 0.1, 0.9}}).report.hand_outside_window());
}

}  // namespace
}  // namespace telepalp::core
