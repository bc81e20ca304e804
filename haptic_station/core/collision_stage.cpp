#include "haptic_station/core/collision_stage.h"

#include <memory>
#include <utility>

#include "haptic_station/loop/plane_snapshot.h"
#include "haptic_station/loop/time_line.h"

namespace telepalp::core {
namespace {

std::shared_ptr<loop::PlaneSnapshot> plane_of(const surface::TouchSample& touch, const surface::SurfaceSnapshot& seen) {
  auto plane = touch.valid ? std::make_shared<loop::PlaneSnapshot>(touch.foot.m, touch.normal, touch.coverage)
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

CollisionStage::Result CollisionStage::run(const Job& job, const StepTime& time) {
  if (loop::begins_new_time_line(job.begun, latest_)) touch_.release();
  latest_ = job.begun;
  if (job.newer) {
    touch_.adopt(*job.newer->snapshot, job.begun);
    seen_ = *job.newer;  // touch_ no longer refers to the last one
  }
  Result result;
  if (seen_.snapshot) {
    const Point<DepthCamera> at = seen_.haptic_from_camera.inverse() * job.device;
    const surface::TouchSample touch = touch_.step(at, job.begun, to_seconds(kPeriod));
    result.plane = loop::TouchableSurface{plane_of(touch, *seen_.snapshot), seen_.haptic_from_camera, ++planes_};
  }
  result.done = time(StageStep::Done);
  return result;
}

}  // namespace telepalp::core
