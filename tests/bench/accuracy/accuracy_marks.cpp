#include "tests/bench/accuracy/accuracy_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

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
constexpr double kLasts_s = 14.0;

/// One radius on one motion, over all spots.
struct MarkFigures {
  explicit MarkFigures(double radius_m) : tracker(radius_m) {}

  surface::MarkTracker tracker;
  RootMeanSquare rise_m;   ///< error along the skin's normal at rest
  RootMeanSquare slide_m;  ///< error along the skin
  int marks = 0;
  int slides_seen = 0;
  Distribution mark_ms;
};

constexpr std::array kRadii_m{0.05, 0.08, surface::kMarkRadius_m, 0.18};

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

/// Adds the errors of one image's marks.
void judge(const capture::SyntheticPatient& patient, const capture::PatientPose& pose, MarkFigures& figures) {
  for (std::size_t i = 0; i < hand::spots().size(); ++i) {
    const hand::Spot& spot = hand::spots()[i];
    const Intrinsics& camera = patient.settings().camera;
    const capture::TrueSurfacePoint rest = patient.surface_of({}).at_pixel(camera.cx + spot.u, camera.cy + spot.v);
    const surface::SkinMark& mark = figures.tracker.marks()[i];
    const Vector3d error = mark.moved_m - (skin_at(patient, spot, pose) - rest.at.m);
    const double along_normal = error.dot(rest.normal.v);
    figures.rise_m.add(along_normal);
    figures.slide_m.add((error - along_normal * rest.normal.v).norm());
    ++figures.marks;
    figures.slides_seen += mark.slide_seen ? 1 : 0;
  }
}

/// The figures of each of kRadii_m: all radii see the same images.
std::vector<MarkFigures> follow(capture::Motion motion) {
  const auto patient = hand::torso(hand::Sensor::Kinect, motion);
  const Intrinsics& camera = patient->settings().camera;
  surface::MarkLines lines;
  for (std::size_t i = 0; i < hand::spots().size(); ++i) {
    const hand::Spot& spot = hand::spots()[i];
    const capture::TrueSurfacePoint rest = patient->surface_of({}).at_pixel(camera.cx + spot.u, camera.cy + spot.v);
    lines[i] = surface::MarkLine{.point = rest.at.m - 0.05 * rest.normal.v, .up = rest.normal.v};
  }
  std::vector<MarkFigures> all(kRadii_m.begin(), kRadii_m.end());
  for (MarkFigures& figures : all) figures.tracker.watch(lines);
  surface::SampleDepths samples;
  surface::TemporalFilter filter(camera.width, camera.height, {});
  for (int n = 0; n / kRate_hz < kLasts_s; ++n) {
    const capture::PatientPose pose = pose_at(*patient, n / kRate_hz);
    const surface::DepthField field = samples.field_of(patient->depth_of(pose, hand::at_time(100.0 + n / kRate_hz)));
    const surface::DepthField& averaged = filter.add(field, 1.0 / kRate_hz);
    for (MarkFigures& figures : all) {
      const double start_us = thread_us();
      figures.tracker.add(averaged, field, camera, 1.0 / kRate_hz);
      const double took_us = thread_us() - start_us;
      if (n / kRate_hz < kRest_s + kRamp_s) continue;
      figures.mark_ms.add(1e-3 * took_us / static_cast<double>(hand::spots().size()));
      judge(*patient, pose, figures);
    }
  }
  return all;
}

}  // namespace

PageTable marks_table() {
  PageTable table{.head = {"radius", "an image and mark, ms, p50", "rise, breathing, mm", "rise, shift, mm",
                           "slide, shift, mm", "slide seen, % of the images"},
                  .rows = {}};
  const std::vector<MarkFigures> breathing = follow(capture::Motion::Irregular);
  const std::vector<MarkFigures> shift = follow(capture::Motion::Shift);
  for (std::size_t i = 0; i < kRadii_m.size(); ++i)
    table.rows.push_back({cell(1e3 * kRadii_m[i]) + " mm" + (kRadii_m[i] == surface::kMarkRadius_m ? " (used)" : ""),
                          cell(breathing[i].mark_ms.p50()), cell(1e3 * breathing[i].rise_m.value()),
                          cell(1e3 * shift[i].rise_m.value()), cell(1e3 * shift[i].slide_m.value()),
                          cell(100.0 * shift[i].slides_seen / shift[i].marks)});
  return table;
}

}  // namespace telepalp::bench
