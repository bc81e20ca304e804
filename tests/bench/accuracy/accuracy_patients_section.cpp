#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "support/program/parallel.h"
#include "tests/bench/accuracy/accuracy_rms.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/accuracy_surface.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/hand/feed.h"
#include "tests/bench/hand/patient.h"

namespace telepalp::bench {
namespace {

constexpr double kPatientLasts_s = 24.0;
constexpr double kFrom_s = 12.0;  // the breathing model has locked on by then
constexpr int kEvery_frames = 10;
constexpr double kAge_s = 0.1;    // age of the snapshot when the hand touches it
constexpr double kMost_m = 0.02;  // error that counts for a point without a surface in the snapshot

/// A column of the table: a motion of the patient, and the camera's height.
struct Column {
  std::string head;
  std::optional<capture::Motion> motion;  ///< nullopt: lies still
  double camera_above_m = hand::kCameraAbove_m;
};

std::vector<Column> columns() {
  std::vector<Column> all;
  for (const double above_m : {0.8, 1.2, 2.0}) {
    char head[32];
    std::snprintf(head, sizeof head, "still, %.1f m", above_m);
    all.push_back({head, std::nullopt, above_m});
  }
  for (const capture::Motion motion : capture::all_motions())
    all.push_back({std::string(capture::name(motion)), motion});
  for (const double above_m : {1.2, 2.0}) {
    char head[32];
    std::snprintf(head, sizeof head, "irregular, %.1f m", above_m);
    all.push_back({head, capture::Motion::Irregular, above_m});
  }
  return all;
}

/// Adds the distance between the snapshot, predicted by `kAge_s`, and the true skin of that instant, at 25 points of
/// the belly. `per_px`: size of a pixel of the camera at 0.8 m, in pixels of this camera.
void add_error(const surface::SurfaceSnapshot& snapshot, const capture::TrueSurface& truth, const Intrinsics& camera,
               const hand::Spot& spot, double per_px, RootMeanSquare& error_m) {
  const surface::MotionBasis basis = surface::motion_basis(snapshot.motion, kAge_s);
  for (int du = -20; du <= 20; du += 10)
    for (int dv = -20; dv <= 20; dv += 10) {
      const auto there = truth.at_pixel(camera.cx + spot.u + per_px * du, camera.cy + spot.v + per_px * dv);
      const surface::FieldSample sample = snapshot.evaluate(there.at.m, there.normal.v, basis);
      error_m.add(sample.valid ? std::min(kMost_m, std::abs(sample.f_m)) : kMost_m);
    }
}

/// RMS error, and the median processor time of a snapshot.
struct Watched {
  double error_mm = 0.0;
  double build_ms = 0.0;
};

Watched watch_on(const SurfaceVariant& variant, const Column& column) {
  const auto patient =
      hand::torso(hand::Sensor::Kinect, column.motion.value_or(capture::Motion::Regular), 1, column.camera_above_m);
  const auto pose = [&](double t) { return column.motion ? patient->pose(hand::at_time(t)) : capture::PatientPose{}; };
  const Intrinsics& camera = patient->settings().camera;
  const double per_px = hand::kCameraAbove_m / column.camera_above_m;
  hand::Spot spot = hand::spots().front();
  spot.u *= per_px;
  spot.v *= per_px;
  const Point<DepthCamera> belly = hand::haptic_from_camera(*patient, spot).inverse() * Point<HapticBase>{};
  VariantStream stream(variant);
  RootMeanSquare error_m;
  Distribution build_ms;
  for (int n = 0; n / 30.0 < kPatientLasts_s; ++n) {
    const double t = 100.0 + n / 30.0;
    const bool judged = n / 30.0 >= kFrom_s && n % kEvery_frames == 0;
    if (!judged && !variant.settings.temporal) continue;
    const DepthImage depth = patient->depth_of(pose(t), hand::at_time(t));
    const double start_us = thread_us();
    const auto snapshot = stream.add(depth, camera, t, surface::Reach{belly, surface::kReach_m});
    build_ms.add(1e-3 * (thread_us() - start_us));
    if (judged) add_error(*snapshot, patient->surface_of(pose(t + kAge_s)), camera, spot, per_px, error_m);
  }
  return {1e3 * error_m.value(), build_ms.p50()};
}

}  // namespace

Result<Section> patients_section() {
  const std::vector<SurfaceVariant> variants = few_variants();
  const std::vector<Column> all = columns();
  std::vector<Watched> watched(variants.size() * all.size());
  program::for_each_parallel(static_cast<int>(watched.size()), program::processors(), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    watched[at] = watch_on(variants[at / all.size()], all[at % all.size()]);
  });
  Section section;
  PageTable table{.head = {"setting"}, .rows = {}};
  for (const Column& column : all) table.head.push_back(column.head);
  table.head.push_back("build ms");
  for (std::size_t v = 0; v < variants.size(); ++v) {
    table.rows.push_back({"`" + variants[v].name + "`"});
    double build_ms = 0.0;
    for (std::size_t c = 0; c < all.size(); ++c) {
      const auto& [off_mm, column_ms] = watched[v * all.size() + c];
      build_ms += column_ms / static_cast<double>(all.size());
      table.rows.back().push_back(cell(off_mm));
      section.rows.push_back(measured(variants[v].name + ": RMS position error, patient " + all[c].head, off_mm, "mm"));
    }
    table.rows.back().push_back(cell(build_ms));
  }
  section.parts = {{"patients", to_markdown(table)}};
  return section;
}

}  // namespace telepalp::bench
