#include "tests/bench/synthetic_bench.h"

#include <cmath>

#include "server/capture/synthetic/source/patient_model.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"

namespace telepalp::bench {
namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr int kFrames = 300;

SessionTime instant(int frame) { return SessionTime{from_seconds(frame / kFramesPerSecond)}; }

/// The largest distance between noise-free depth and the true surface, over a breath [mm].
Result<double> worst_error_mm(const capture::TriangleMesh& torso) {
  capture::SyntheticSettings exact;
  exact.noise = capture::DepthNoise::None;
  exact.disparity_steps = false;
  exact.depth_unit_m = 0.0001;
  const Result<capture::SyntheticPatient> patient = capture::SyntheticPatient::make(torso, exact);
  if (!patient) return patient.error();
  double worst_m = 0.0;
  for (int frame = 0; frame < 120; frame += 20) {
    const RgbdFrame seen = patient->frame_at(instant(frame), 0);
    const capture::TrueSurface truth = patient->true_surface(instant(frame));
    for (int v = 0; v < seen.depth.height; v += 2)
      for (int u = 0; u < seen.depth.width; u += 2)
        if (const std::uint16_t sample = seen.depth.at(u, v); sample != 0)
          worst_m = std::max(worst_m, std::abs(sample * seen.depth.unit_m - truth.depth_m(u, v)));
  }
  return 1000.0 * worst_m;
}

}  // namespace

Result<Report> run_synthetic(const program::Arguments& /*arguments*/) {
  const Result<capture::TriangleMesh> torso = capture::shipped_torso();
  if (!torso) return torso.error();
  const double before_us = thread_us();
  const Result<capture::SyntheticPatient> patient = capture::SyntheticPatient::make(*torso, {});
  if (!patient) return patient.error();
  const double making_ms = 1e-3 * (thread_us() - before_us);

  Distribution frame_ms;
  for (int frame = 0; frame < kFrames; ++frame) {
    const double start_us = thread_us();
    const RgbdFrame seen = patient->frame_at(instant(frame), 0);
    frame_ms.add(1e-3 * (thread_us() - start_us));
  }
  const Result<double> worst_mm = worst_error_mm(*torso);
  if (!worst_mm) return worst_mm.error();
  const double share_of_ms = kFramesPerSecond / 1000.0;
  return Report{
      .bench = "synthetic",
      .rows = {measured("making a frame: processor time, p50", frame_ms.p50(), "ms"),
               measured("making a frame: processor time, p99", frame_ms.p99(), "ms"),
               measured("making the patient: processor time", making_ms, "ms"),
               at_most("share of one core for 30 frames/s, by the p50", frame_ms.p50() * share_of_ms, "", 0.25),
               at_most("share of one core for 30 frames/s, by the p99", frame_ms.p99() * share_of_ms, "", 0.5),
               at_most("depth without noise: largest error", *worst_mm, "mm", 0.1)},
      .notes = {"640x480 depth and colour, Kinect noise, steps and holes; 300 frames of a breathing torso"}};
}

}  // namespace telepalp::bench
