#include "haptic_station/station/threads/collision_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "haptic_station/surface/build/surface_builder.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

/// A level skin at 0.9 m in front of the camera, captured at `captured`.
loop::TouchableSurface level_skin(SessionTime captured) {
  const Intrinsics camera{.width = 160, .height = 120, .fx = 130, .fy = 130, .cx = 79.5, .cy = 59.5};
  const DepthImage depth{
      .width = 160, .height = 120, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(160 * 120, 900)};
  return {surface::build_snapshot(depth, camera, captured, std::nullopt, *surface::surface_settings("paper")), {}};
}

TEST(CollisionThread, AfterTheSessionClockStepsBackNewImagesAreFelt) {
  LatestValue<loop::TouchableSurface> seen;
  LatestValue<Point<HapticBase>> device;
  LatestValue<loop::TouchableSurface> planes;
  std::atomic<std::int64_t> now_ns = to_nanoseconds(session_time(0) + 3h);
  CollisionThread thread(seen, device, planes, [&] { return session_time(now_ns); });
  const Eigen::Vector3d finger(0.0, 0.0, 0.895);
  device.put({finger});
  /// True when the plane of an image captured at `captured` is handed over with full support, within 10 s.
  const auto feels = [&](SessionTime captured) {
    seen.put(level_skin(captured));
    for (int tries = 0; tries < 10'000; ++tries, std::this_thread::sleep_for(1ms)) {
      if (!planes.take() || planes.current().snapshot->captured != captured) continue;
      const auto plane = planes.current().snapshot->evaluate(finger, -Eigen::Vector3d::UnitZ(), {});
      if (plane.valid && plane.coverage > 0.9) return true;
    }
    return false;
  };
  EXPECT_TRUE(feels(session_time(now_ns)));
  now_ns -= std::chrono::nanoseconds(2h).count();
  EXPECT_TRUE(feels(session_time(now_ns)));
}

}  // namespace
}  // namespace telepalp::station
