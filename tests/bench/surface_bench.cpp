#include "tests/bench/surface_bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "tests/bench/distribution.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/haptic_station/surface/shape_error.h"
#include "tests/haptic_station/surface/touch_scenario.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using surface::Reach;
using surface::SurfaceSettings;
using surface::SurfaceSnapshot;
using testing::Captured;
using testing::scene_time;
using Clock = std::chrono::steady_clock;

constexpr double kStiffness_N_per_m = 500.0;

double since_us(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

Distribution distribution(const std::vector<double>& samples) {
  Distribution all;
  for (const double sample : samples) all.add(sample);
  return all;
}

/// Time from a decoded depth image to a snapshot that can be touched, for 90 frames; the hand goes back and forth.
Distribution build_times_ms(const std::vector<RgbdFrame>& frames, const testing::Spot& spot, double hand_m_per_s) {
  surface::SurfaceBuilder builder{SurfaceSettings{}};
  Distribution times;
  for (int n = 0; n < 90; ++n) {
    const RgbdFrame& frame = frames[static_cast<std::size_t>(n) % frames.size()];
    const double along = 0.05 * std::sin(n * kFrame_s * hand_m_per_s / 0.05);
    const Reach reach{{spot.at + Vector3d(along, 0.0, 0.0)}, surface::kReach_m};
    const auto start = Clock::now();
    const auto snapshot = builder.add(frame.depth, frame.camera.depth, scene_time(n * kFrame_s), reach);
    const double took_ms = since_us(start) / 1000.0;
    if (snapshot && n >= 5) times.add(took_ms);
  }
  return times;
}

/// Time of a step while the device circles 10 mm under the skin; `swap`: snapshots come at 30 Hz.
Distribution step_times_us(const std::vector<Captured>& snapshots, const testing::Spot& spot, int ticks, bool swap) {
  surface::TouchSettings settings;
  settings.stale_after_s = 1e9;
  surface::Touch touch(settings);
  Distribution times;
  times.reserve(static_cast<std::size_t>(ticks));
  touch.adopt(*snapshots.front().snapshot, scene_time(snapshots.front().at_s));
  constexpr int kTicksAFrame = 67;
  for (int tick = 0; tick < ticks; ++tick) {
    const double t = tick * kTick_s;
    const Vector3d circle(0.015 * std::sin(4.0 * t), 0.015 * std::cos(4.0 * t), 0.0);
    const double depth_m = std::min(0.01, 0.05 * t - 0.01);
    const Vector3d at = spot.at + circle - depth_m * spot.normal;
    const SurfaceSnapshot& newest =
        *snapshots[static_cast<std::size_t>(tick / kTicksAFrame) % snapshots.size()].snapshot;
    const auto start = Clock::now();
    if (swap && tick % kTicksAFrame == 0) touch.adopt(newest, scene_time(t));
    const auto sample = touch.step({at}, scene_time(t), kTick_s);
    const double took_us = since_us(start);
    if (t > 0.5 && sample.in_body) times.add(took_us);
  }
  return times;
}

void add_costs(Report& report, const capture::SyntheticPatient& patient, const testing::Spot& spot) {
  std::vector<RgbdFrame> frames;
  for (int n = 0; n < 15; ++n) frames.push_back(patient.frame_at(scene_time(n * kFrame_s), 0));
  const Distribution still = build_times_ms(frames, spot, 0.0);
  const Distribution moving = build_times_ms(frames, spot, 1.0);
  report.rows.push_back(measured("depth image to touchable surface, hand still: time, p50", still.p50(), "ms"));
  report.rows.push_back(at_most("depth image to touchable surface, hand still: time, p99", still.p99(), "ms", 8.0));
  report.rows.push_back(at_most("depth image to touchable surface, hand at 1 m/s: time, p99", moving.p99(), "ms", 8.0));
  report.rows.push_back(at_most("depth image to touchable surface, p50: hand at 1 m/s, divided by hand still",
                                moving.p50() / still.p50(), "x", 1.10));

  const Reach reach{{spot.at}, surface::kReach_m};
  const std::vector<Captured> fast = testing::watch(patient, SurfaceSettings{}, reach, 1.0, 0.5);
  const std::vector<Captured> paper = testing::watch(patient, *surface::surface_settings("paper"), reach, 0.1, 0.0);
  const Distribution swapping = step_times_us(fast, spot, 40000, true);
  const Distribution steady = step_times_us(fast, spot, 40000, false);
  const Distribution reference = step_times_us(paper, spot, 8000, true);
  report.rows.push_back(at_most("proxy step in contact: time, p50", swapping.p50(), "us", 3.0));
  report.rows.push_back(measured("proxy step in contact: time, p99", swapping.p99(), "us"));
  report.rows.push_back(at_most("proxy step in contact: time, p99.9", swapping.p999(), "us", 25.0));
  report.rows.push_back(measured("proxy step in contact, surface setting paper: time, p50", reference.p50(), "us"));
  report.rows.push_back(at_least("proxy step in contact, p50: surface setting paper, divided by the default",
                                 reference.p50() / swapping.p50(), "x", 5.0));
  report.rows.push_back(measured("proxy step, snapshot never swapped: time, p50", steady.p50(), "us"));
  report.rows.push_back(measured("proxy step, snapshot never swapped: time, p99", steady.p99(), "us"));
  report.rows.push_back(at_most("proxy step, p99: snapshot swapped at 30 Hz, divided by never swapped",
                                swapping.p99() / steady.p99(), "x", 1.10));
}

void add_shapes(Report& report) {
  double worst_um = 0.0;
  double worst_deg = 0.0;
  for (const auto& shape : testing::smooth_shapes()) {
    const testing::ShapeError error = testing::shape_error(*shape, SurfaceSettings{}, {});
    worst_um = std::max(worst_um, 1e6 * error.position_rms_m);
    worst_deg = std::max(worst_deg, error.normal_rms_deg);
  }
  report.rows.push_back(at_most("shapes without noise: RMS position error, worst shape", worst_um, "um", 10.0));
  report.rows.push_back(
      at_most("shapes without noise: RMS error of the surface normal, worst shape", worst_deg, "deg", 0.2));
}

/// Greatest change of f over 1 um of travel on noisy lines along and across the surface.
double worst_jump_um(const SurfaceSnapshot& snapshot, const testing::Spot& spot) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> any(0.0, 1.0);
  double worst = 0.0;
  for (int line = 0; line < 40; ++line) {
    const Vector3d direction = Vector3d(any(random), any(random), any(random)).normalized();
    Vector3d at = spot.at + 0.003 * Vector3d(any(random), any(random), 0.0) + 0.001 * any(random) * spot.normal;
    double last = snapshot.evaluate(at, spot.normal, {}).f_m;
    for (int step = 0; step < 3000; ++step) {
      at += 1e-6 * direction;
      const double f = snapshot.evaluate(at, spot.normal, {}).f_m;
      worst = std::max(worst, std::abs(f - last));
      last = f;
    }
  }
  return 1e6 * worst;
}

void add_still(Report& report, const capture::SyntheticPatient& patient, const testing::Spot& spot) {
  const Reach reach{{spot.at}, surface::kReach_m};
  const std::vector<Captured> second = testing::watch(patient, SurfaceSettings{}, reach, 4.0, 0.95);
  const testing::ShapeError error = testing::torso_error(patient, *second.front().snapshot, spot);
  report.rows.push_back(
      at_most("torso with 1 mm noise, after 1 s: RMS position error", 1e3 * error.position_rms_m, "mm", 0.25));
  report.rows.push_back(
      at_most("torso with 1 mm noise, after 1 s: RMS error of the surface normal", error.normal_rms_deg, "deg", 1.5));
  report.rows.push_back(at_most("largest change of the implicit function f over 1 um of travel",
                                worst_jump_um(*second.front().snapshot, spot), "um", 2.0));
  const auto paper = surface::build_snapshot(patient.frame_at(scene_time(0.0), 0).depth, patient.settings().camera,
                                             scene_time(0.0), reach, *surface::surface_settings("paper-nanoflann"));
  report.rows.push_back(
      measured("largest change of the implicit function f over 1 um of travel, surface setting paper-nanoflann",
               worst_jump_um(*paper, spot), "um"));
  const Vector3d inside = spot.at - 0.01 * spot.normal;
  const auto held = testing::run_touch(
      patient, second, [&](double) { return inside; }, 1.0, 4.0, 0.0, kStiffness_N_per_m);
  report.rows.push_back(at_most("device held still in the skin: force change in one tick, p99.9",
                                distribution(held.force_change_N).p999(), "N", 0.02));
  report.rows.push_back(
      at_most("device held still in the skin: share of ticks without contact", 100.0 * held.lost_share, "%", 0.0));
  report.rows.push_back(measured("device held still in the skin: force RMSE", held.force_rmse_N, "N"));
}

/// Places on the belly within 30 mm of `spot`, each 10 mm under the skin at exhale.
std::vector<Vector3d> presses(const capture::SyntheticPatient& patient, const testing::Spot& spot) {
  std::vector<Vector3d> inside;
  const capture::TrueSurface skin = patient.true_surface(scene_time(0.0));
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {-0.03, -0.03}, {-0.03, 0.03}, {0.03, -0.03}, {0.03, 0.03}}) {
    const auto point = skin.on_ray_through({spot.at + Vector3d(x, y, 0.0)});
    inside.emplace_back(point.at.m - 0.01 * point.normal.v);
  }
  return inside;
}

/// Root of the mean over places of the squared force error.
double force_rmse_N(const capture::SyntheticPatient& patient, const std::vector<Captured>& snapshots,
                    const std::vector<Vector3d>& places, double from_s, double until_s, double delay_s) {
  double square = 0.0;
  for (const Vector3d& at : places) {
    const auto run = testing::run_touch(
        patient, snapshots, [&](double) { return at; }, from_s, until_s, delay_s, kStiffness_N_per_m);
    square += run.force_rmse_N * run.force_rmse_N;
  }
  return std::sqrt(square / static_cast<double>(places.size()));
}

Result<void> add_breathing(Report& report) {
  const auto patient = testing::torso({.sigma_m = 0.001, .amplitude_m = 0.005});
  if (!patient) return patient.error();
  const testing::Spot spot = testing::belly(*patient);
  const Reach reach{{spot.at}, 0.08};
  const std::vector<Vector3d> places = presses(*patient, spot);
  const auto held = [&](double) { return places.front(); };
  const std::vector<Captured> all = testing::watch(*patient, SurfaceSettings{}, reach, 20.0, 2.0);
  const std::pair<double, double> asked[] = {{0.05, 0.02}, {0.10, 0.04}, {0.20, 0.08}};
  for (const auto& [delay_s, reach_N] : asked) {
    report.rows.push_back(
        at_most("breathing: force RMSE at a delay of " + std::to_string(static_cast<int>(1e3 * delay_s)) + " ms",
                force_rmse_N(*patient, all, places, 12.0, 20.0, delay_s), "N", reach_N));
  }
  for (const auto& [delay_s, reach_N] : asked) {
    report.rows.push_back(measured(
        "breathing, first 6 s: force RMSE at a delay of " + std::to_string(static_cast<int>(1e3 * delay_s)) + " ms",
        force_rmse_N(*patient, all, places, 2.5, 6.0, delay_s), "N"));
  }
  std::mt19937_64 random(9);
  std::bernoulli_distribution lost(0.1);
  const std::vector<Captured> lossy =
      testing::watch(*patient, SurfaceSettings{}, reach, 20.0, 11.0, [&](int) { return lost(random); });
  report.rows.push_back(at_most("breathing, 10 % of frames lost: force RMSE at a delay of 50 ms",
                                force_rmse_N(*patient, lossy, places, 12.0, 20.0, 0.05), "N", 0.025));
  const std::vector<Captured> gap = testing::watch(*patient, SurfaceSettings{}, reach, 18.0, 11.0,
                                                   [](int n) { return n * kFrame_s > 14.0 && n * kFrame_s < 14.5; });
  const auto outage = testing::run_touch(*patient, gap, held, 12.0, 18.0, 0.05, kStiffness_N_per_m,
                                         [](double t) { return t > 14.0 && t < 14.5; });
  report.rows.push_back(at_most("outage of 500 ms, then a burst of frames: largest force change in one tick",
                                distribution(outage.force_change_N).max(), "N", 0.02));
  report.rows.push_back(measured("outage of 500 ms, then a burst of frames: force RMSE", outage.force_rmse_N, "N"));
  return {};
}

}  // namespace

Result<Report> run_surface(const program::Arguments& /*arguments*/) {
  const auto patient = testing::torso({.sigma_m = 0.001});
  if (!patient) return patient.error();
  const testing::Spot spot = testing::belly(*patient);
  Report report{.bench = "surface", .rows = {}, .notes = {}};
  add_costs(report, *patient, spot);
  add_shapes(report);
  add_still(report, *patient, spot);
  if (const Result<void> done = add_breathing(report); !done) return done.error();
  report.notes = {
      "synthetic torso, 640x480, Gaussian noise of 1 mm, with holes; surface built within 0.16 m of the device",
      "proxy step: device circles at 60 mm/s, 10 mm deep in the skin; snapshots at 30 Hz",
      "breathing: 5 mm at 0.25 Hz, device 10 mm deep at five places; RMSE of the force vector",
      "shapes: points 1.5 mm apart, radius >= 50 mm, camera at most 40 degrees from the normal"};
  return report;
}

}  // namespace telepalp::bench
