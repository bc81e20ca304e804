#include "haptic_station/surface/build/mark_tracker.h"

#include <cmath>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr int kFirstFrames = 10;          // frames in the average from which a patch is taken
constexpr double kMostSlide_m = 0.001;    // a slide is seen once its 1-sigma error is below this
constexpr double kStillSlide_m = 0.0012;  // and until its error reaches this: hysteresis
constexpr double kSlideOver_s = 0.2;      // time constant of the slide's average
constexpr double kModel_m = 0.0003;       // 1-sigma of the part of the rise that the polynomial cannot represent

}  // namespace

void MarkTracker::watch(const MarkLines& lines) {
  for (std::size_t i = 0; i < kMostMarks; ++i) {
    followed_[i] = {};
    followed_[i].line = lines[i];
    marks_[i] = {};
    marks_[i].watched = lines[i].has_value();
  }
}

void MarkTracker::restart() {
  MarkLines lines;
  for (std::size_t i = 0; i < kMostMarks; ++i) lines[i] = followed_[i].line;
  watch(lines);
}

void MarkTracker::add(const DepthField& averaged, const DepthField& seen, const Intrinsics& camera, double dt_s) {
  for (std::size_t i = 0; i < kMostMarks; ++i) {
    if (!followed_[i].line) continue;
    if (followed_[i].patch)
      follow(followed_[i], marks_[i], seen, camera, dt_s);
    else
      begin(followed_[i], marks_[i], averaged, camera);
  }
}

void MarkTracker::begin(Followed& one, SkinMark& mark, const DepthField& averaged, const Intrinsics& camera) const {
  if (++one.frames < kFirstFrames) return;
  one.patch = skin_patch(averaged, camera, one.line->point, one.line->up, radius_m_);
  if (!one.patch) return;
  mark.at = one.patch->mark;
  mark.normal = one.patch->normal;
}

/// Updates the motion along the skin's normal in each frame, and the motion along the skin only while it is observable.
void MarkTracker::follow(Followed& one, SkinMark& mark, const DepthField& seen, const Intrinsics& camera, double dt_s) {
  const PatchSearch search(*one.patch, seen, camera, one.pose);
  PatchPose found = search.found(true);
  mark.seen = found.seen;
  mark.slide_seen = found.seen && found.sigma_slide_m < (mark.slide_seen ? kStillSlide_m : kMostSlide_m);
  if (!mark.seen) return;
  mark.sigma_slide_m = found.sigma_slide_m;
  if (mark.slide_seen)
    found.slide_m = one.pose.slide_m - std::expm1(-dt_s / kSlideOver_s) * (found.slide_m - one.pose.slide_m);
  else
    found = search.found(false);
  if (!found.seen) return;
  one.pose = found;
  const Vector3d& normal = one.patch->normal;
  const Vector3d moved_m{found.slide_m.x(), found.slide_m.y(), found.deeper_m};
  const double risen_m = normal.dot(moved_m);
  if (mark.slide_seen) one.slid_m = moved_m - risen_m * normal;
  mark.moved_m = one.slid_m + risen_m * normal;
  mark.at = one.patch->mark + mark.moved_m;
  mark.sigma_normal_m = std::abs(normal.z()) * std::hypot(found.sigma_depth_m, kModel_m);
}

}  // namespace telepalp::surface
