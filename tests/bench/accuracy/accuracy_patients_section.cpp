#include <array>
#include <cmath>

#include "tests/bench/accuracy/accuracy_rms.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/accuracy_surface.h"
#include "tests/bench/hand/feed.h"
#include "tests/bench/hand/patient.h"

namespace telepalp::bench {
namespace {

constexpr double kLasts_s = 24.0;
constexpr double kFrom_s = 12.0;  // the breathing model has locked on by then
constexpr int kEvery_frames = 10;
constexpr double kAge_s = 0.1;    // age of the snapshot when the hand touches it
constexpr double kMost_m = 0.02;  // error that counts for a point without a surface in the snapshot

/// Adds the distance between the snapshot, predicted by `kAge_s`, and the true skin of that instant, at 25 points of
/// the belly.
void add_error(const surface::SurfaceSnapshot& snapshot, const capture::TrueSurface& truth, const Intrinsics& camera,
               const hand::Spot& spot, RootMeanSquare& error_m) {
  const surface::MotionBasis basis = surface::motion_basis(snapshot.motion, kAge_s);
  for (int du = -20; du <= 20; du += 10)
    for (int dv = -20; dv <= 20; dv += 10) {
      const auto there = truth.at_pixel(camera.cx + spot.u + du, camera.cy + spot.v + dv);
      const surface::FieldSample sample = snapshot.evaluate(there.at.m, there.normal.v, basis);
      error_m.add(sample.valid ? std::min(kMost_m, std::abs(sample.f_m)) : kMost_m);
    }
}

double error_on(const SurfaceVariant& variant, capture::Motion motion) {
  const auto patient = hand::torso(hand::Sensor::Kinect, motion);
  const Intrinsics& camera = patient->settings().camera;
  const hand::Spot spot = hand::spots().front();
  const Point<DepthCamera> belly = hand::haptic_from_camera(*patient, spot).inverse() * Point<HapticBase>{};
  VariantStream stream(variant);
  RootMeanSquare error_m;
  for (int n = 0; n / 30.0 < kLasts_s; ++n) {
    const double t = 100.0 + n / 30.0;
    const bool judged = n / 30.0 >= kFrom_s && n % kEvery_frames == 0;
    if (!judged && !variant.settings.temporal) continue;
    const DepthImage depth = patient->depth_of(patient->pose(hand::at_time(t)), hand::at_time(t));
    const auto snapshot = stream.add(depth, camera, t, surface::Reach{belly, 0.16});
    if (judged) add_error(*snapshot, patient->true_surface(hand::at_time(t + kAge_s)), camera, spot, error_m);
  }
  return error_m.value();
}

}  // namespace

Result<Section> patients_section() {
  Section section;
  PageTable table{.head = {"setting"}, .rows = {}};
  for (const capture::Motion motion : capture::all_motions()) table.head.push_back(std::string(capture::name(motion)));
  for (const SurfaceVariant& variant : few_variants()) {
    table.rows.push_back({"`" + variant.name + "`"});
    for (const capture::Motion motion : capture::all_motions()) {
      const double error_mm = 1e3 * error_on(variant, motion);
      table.rows.back().push_back(cell(error_mm));
      section.rows.push_back(
          measured(variant.name + ": patient, " + std::string(capture::name(motion)), error_mm, "mm"));
    }
  }
  section.parts = {{"patients", to_markdown(table)}};
  return section;
}

}  // namespace telepalp::bench
