#include "haptic_station/station/threads/collision_thread.h"

#include <memory>
#include <utility>

#include "haptic_station/loop/plane_snapshot.h"
#include "haptic_station/loop/time_line.h"
#include "haptic_station/station/threads/tick_timer.h"

namespace telepalp::station {
namespace {

constexpr std::chrono::milliseconds kPeriod{10};  // S1 II.C: 100 Hz

std::shared_ptr<loop::PlaneSnapshot> plane_of(const surface::TouchSample& touch, const surface::SurfaceSnapshot& seen) {
  auto plane = touch.valid ? std::make_shared<loop::PlaneSnapshot>(touch.foot.m, touch.normal, touch.support)
                           : std::make_shared<loop::PlaneSnapshot>();
  plane->captured = seen.captured;
  plane->sequence = seen.sequence;
  plane->points = seen.points;
  plane->index_name = seen.index_name;
  plane->motion.ages = seen.motion.ages;
  plane->marks = seen.marks;
  return plane;
}

}  // namespace

CollisionThread::CollisionThread(LatestValue<loop::TouchableSurface>& from_surface,
                                 LatestValue<Point<HapticBase>>& device, LatestValue<loop::TouchableSurface>& to_haptic,
                                 std::function<SessionTime()> now)
    : from_surface_(from_surface), device_(device), to_haptic_(to_haptic), now_(std::move(now)), thread_([this] {
        run();
      }) {}

CollisionThread::~CollisionThread() {
  running_ = false;
  thread_.join();
}

void CollisionThread::run() {
  TickTimer timer(TickTimer::Clock::now() + kPeriod, kPeriod);
  while (running_) {
    (void)timer.wait();
    detection_.detect(from_surface_, device_, to_haptic_, now_());
  }
}

void CollisionDetection::detect(LatestValue<loop::TouchableSurface>& from_surface,
                                LatestValue<Point<HapticBase>>& device, LatestValue<loop::TouchableSurface>& to_haptic,
                                SessionTime now) {
  if (loop::begins_new_time_line(now, latest_)) touch_.release();
  latest_ = now;
  if (from_surface.take()) touch_.adopt(*from_surface.current().snapshot, now);
  (void)device.take();
  const loop::TouchableSurface& seen = from_surface.current();
  if (!seen.snapshot) return;
  const Point<DepthCamera> at = seen.haptic_from_camera.inverse() * device.current();
  const surface::TouchSample touch = touch_.step(at, now, std::chrono::duration<double>(kPeriod).count());
  to_haptic.put({plane_of(touch, *seen.snapshot), seen.haptic_from_camera});
}

}  // namespace telepalp::station
