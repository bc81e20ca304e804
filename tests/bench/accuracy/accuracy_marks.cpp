#include "tests/bench/accuracy/accuracy_marks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "haptic_station/surface/build/mark_tracker.h"
#include "haptic_station/surface/depth/sample_depths.h"
#include "haptic_station/surface/temporal/temporal_filter.h"
#include "tests/bench/accuracy/accuracy_rms.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/hand/feed.h"
#include "tests/bench/hand/patient.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRate_hz = 30.0;
constexpr double kRest_s = 1.0;  // the patient holds still, and the patch is taken
constexpr double kRamp_s = 1.0;  // over which the motion begins
constexpr double kLasts_s = 20.0;

struct MarkFigures {
  RootMeanSquare rise_m;   ///< error along the skin's normal at rest
  RootMeanSquare slide_m;  ///< error along the skin
  int images = 0;
  int slides_seen = 0;
  Distribution image_ms;
};

/// The patient's pose at `t_s`: at rest first, then the motion, which begins gradually.
capture::PatientPose pose_at(const capture::SyntheticPatient& patient, double t_s) {
  capture::PatientPose pose = patient.pose(hand::at_time(100.0 + t_s));
  const double share = std::clamp((t_s - kRest_s) / kRamp_s, 0.0, 1.0);
  pose.breath.lift_m *= share;
  pose.slide_m *= share;
  pose.rise_m *= share;
  pose.tilt *= share;
  return pose;
}

/// Where the skin that lies at `spot` at rest is in this pose.
Vector3d skin_at(const capture::SyntheticPatient& patient, const hand::Spot& spot, const capture::PatientPose& pose) {
  const Intrinsics& camera = patient.settings().camera;
  const double px_per_m = camera.fx / patient.settings().camera_above_body_m;
  const Vector2d at = Vector2d(camera.cx + spot.u, camera.cy + spot.v) - px_per_m * pose.slide_m;
  return patient.surface_of(pose).at_pixel(at.x(), at.y()).at.m;
}

void follow(double radius_m, capture::Motion motion, const hand::Spot& spot, MarkFigures& figures) {
  const auto patient = hand::torso(hand::Sensor::Kinect, motion);
  const Intrinsics& camera = patient->settings().camera;
  const capture::TrueSurfacePoint rest = patient->surface_of({}).at_pixel(camera.cx + spot.u, camera.cy + spot.v);
  surface::SampleDepths samples;
  surface::TemporalFilter filter(camera.width, camera.height, {});
  surface::MarkTracker tracker(radius_m);
  surface::MarkLines lines;
  lines[0] = surface::MarkLine{.point = rest.at.m - 0.05 * rest.normal.v, .up = rest.normal.v};
  tracker.watch(lines);
  for (int n = 0; n / kRate_hz < kLasts_s; ++n) {
    const capture::PatientPose pose = pose_at(*patient, n / kRate_hz);
    const surface::DepthField field = samples.field_of(patient->depth_of(pose, hand::at_time(100.0 + n / kRate_hz)));
    const surface::DepthField& averaged = filter.add(field, 1.0 / kRate_hz);
    const double start_us = thread_us();
    tracker.add(averaged, field, camera, 1.0 / kRate_hz);
    const double took_us = thread_us() - start_us;
    if (n / kRate_hz < kRest_s + kRamp_s) continue;
    const surface::SkinMark& mark = tracker.marks()[0];
    const Vector3d error = mark.moved_m - (skin_at(*patient, spot, pose) - rest.at.m);
    const double along_normal = error.dot(rest.normal.v);
    figures.image_ms.add(1e-3 * took_us);
    figures.rise_m.add(along_normal);
    figures.slide_m.add((error - along_normal * rest.normal.v).norm());
    ++figures.images;
    figures.slides_seen += mark.slide_seen ? 1 : 0;
  }
}

}  // namespace

PageTable marks_table() {
  PageTable table{.head = {"radius", "an image and mark, ms, p50", "rise, breathing, mm", "rise, shift, mm",
                           "slide, shift, mm", "slide seen, % of the images"},
                  .rows = {}};
  for (const double radius_m : {0.05, 0.08, surface::kMarkRadius_m, 0.18}) {
    MarkFigures breathing;
    MarkFigures shift;
    for (const hand::Spot& spot : hand::spots()) {
      follow(radius_m, capture::Motion::Irregular, spot, breathing);
      follow(radius_m, capture::Motion::Shift, spot, shift);
    }
    table.rows.push_back({cell(1e3 * radius_m) + " mm" + (radius_m == surface::kMarkRadius_m ? " (used)" : ""),
                          cell(breathing.image_ms.p50()), cell(1e3 * breathing.rise_m.value()),
                          cell(1e3 * shift.rise_m.value()), cell(1e3 * shift.slide_m.value()),
                          cell(100.0 * shift.slides_seen / shift.images)});
  }
  return table;
}

}  // namespace telepalp::bench
