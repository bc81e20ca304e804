#include "tests/bench/accuracy/accuracy_surface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "haptic_station/surface/touch/touch.h"
#include "server/capture/synthetic/source/patient_model.h"
#include "tests/bench/accuracy/accuracy_page.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/haptic_station/surface/shape_error.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using surface::Reach;
using surface::SurfaceSnapshot;
using surface::Touch;
using surface::TouchSample;
using testing::scene_time;
using Clock = std::chrono::steady_clock;

constexpr double kSteepestView = 0.77;  // cosine of 40 degrees; slope_touch_error() measures steeper places
constexpr int kPressSteps = 24;
constexpr int kSettleSteps = 12;
constexpr double kMostSeconds = 1.0;  // longest time of a measurement; slow variants are measured at fewer points
constexpr int kLeastPlaces = 9;

/// Processor time of this thread [s], so that other programs do not shorten a measurement.
double spent_s() { return 1e-6 * thread_us(); }

/// The true surface at a point: unit normal and signed distance.
struct Truth {
  Vector3d normal = Vector3d::Zero();
  double distance_m = 0.0;
};

/// Comes along a ray and stays below the surface.
TouchSample press(const SurfaceSnapshot& snapshot, const Vector3d& from, const Vector3d& to) {
  surface::TouchSettings settings;
  settings.stale_after_s = 1e9;
  Touch touch(settings);
  touch.adopt(snapshot, snapshot.captured);
  TouchSample last;
  for (int i = 0; i <= kPressSteps + kSettleSteps; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / kPressSteps);
    last = touch.step({from + share * (to - from)}, snapshot.captured, kTick_s);
  }
  return last;
}

/// Presses along the ray to each point of `on_surface`, until all are done or the time is over.
TouchError press_all(const SurfaceSnapshot& snapshot, const std::vector<Vector3d>& on_surface,
                     const std::function<std::optional<Truth>(const Vector3d&)>& truth) {
  TouchError error;
  double square_m2 = 0.0;
  double square_sine = 0.0;
  const double start_s = spent_s();
  for (const Vector3d& at : on_surface) {
    if (error.places >= kLeastPlaces && spent_s() - start_s > kMostSeconds) break;
    ++error.places;
    const TouchSample sample = press(snapshot, 0.97 * at, 1.01 * at);
    const std::optional<Truth> there = sample.in_body ? truth(sample.foot.m) : std::nullopt;
    if (!there) continue;
    ++error.touched;
    square_m2 += there->distance_m * there->distance_m;
    square_sine += there->normal.cross(sample.normal).squaredNorm();
  }
  error.position_m = std::sqrt(square_m2 / error.touched);
  error.normal_deg = std::sqrt(square_sine / error.touched) * 180.0 / std::numbers::pi;
  return error;
}

/// Greatest change of f over 1 µm of travel, on random lines through points of the surface.
double jump_um(const SurfaceSnapshot& snapshot, const testing::Spot& spot) {
  constexpr int kLines = 30;
  constexpr int kSteps = 1000;
  std::mt19937_64 random(4);
  std::normal_distribution<double> any(0.0, 1.0);
  double worst_m = 0.0;
  const double start_s = spent_s();
  for (int line = 0; line < kLines && spent_s() - start_s < kMostSeconds; ++line) {
    const Vector3d direction = Vector3d(any(random), any(random), any(random)).normalized();
    Vector3d at = spot.at + 0.003 * Vector3d(any(random), any(random), 0.0) + 0.001 * any(random) * spot.normal;
    double last_m = snapshot.evaluate(at, spot.normal, {}).f_m;
    for (int step = 0; step < kSteps; ++step) {
      at += 1e-6 * direction;
      const double f_m = snapshot.evaluate(at, spot.normal, {}).f_m;
      worst_m = std::max(worst_m, std::abs(f_m - last_m));
      last_m = f_m;
    }
  }
  return 1e6 * worst_m;
}

/// Time of a step while the device circles 10 mm under the skin.
Distribution step_times_us(const SurfaceSnapshot& snapshot, const testing::Spot& spot) {
  constexpr int kTicks = 12000;
  surface::TouchSettings settings;
  settings.stale_after_s = 1e9;
  Touch touch(settings);
  touch.adopt(snapshot, snapshot.captured);
  Distribution times;
  const double begin_s = spent_s();
  for (int tick = 0; tick < kTicks && (times.count() < 200 || spent_s() - begin_s < kMostSeconds); ++tick) {
    const double t_s = tick * kTick_s;
    const Vector3d circle(0.015 * std::sin(4.0 * t_s), 0.015 * std::cos(4.0 * t_s), 0.0);
    const Vector3d at = spot.at + circle - std::min(0.01, 0.2 * t_s - 0.01) * spot.normal;
    const auto start = Clock::now();
    const TouchSample sample = touch.step({at}, snapshot.captured, kTick_s);
    const double took_us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
    if (sample.in_body) times.add(took_us);
  }
  return times;
}

std::vector<Vector3d> places_on(const testing::AnalyticSurface& shape) {
  std::vector<Vector3d> places;
  for (double x = -0.01; x <= 0.05; x += 0.0142)
    for (double y = -0.03; y <= 0.03; y += 0.0142) {
      const Vector3d ray(x / 0.8, y / 0.8, 1.0);
      const double z = shape.depth_along(ray.x(), ray.y());
      if (z > 0.0 && -shape.foot(z * ray).normal.dot(ray.normalized()) > kSteepestView) places.push_back(z * ray);
    }
  return places;
}

/// Places on a shape in front of the camera whose normal is within 2 degrees of `slope_deg` off the ray to them.
std::vector<Vector3d> places_at_slope(const testing::AnalyticSurface& shape, double slope_deg) {
  std::vector<Vector3d> places;
  for (double x = -0.09; x <= 0.09; x += 0.0031)
    for (double y = -0.09; y <= 0.09; y += 0.0031) {
      const Vector3d ray(x / 0.8, y / 0.8, 1.0);
      const double z = shape.depth_along(ray.x(), ray.y());
      if (!(z > 0.0)) continue;
      const double facing = -shape.foot(z * ray).normal.dot(ray.normalized());
      if (std::abs(std::acos(std::clamp(facing, -1.0, 1.0)) * 180.0 / std::numbers::pi - slope_deg) <= 2.0)
        places.push_back(z * ray);
    }
  return places;
}

TouchError torso_error(const FilmedTorso& torso, const SurfaceSnapshot& snapshot) {
  const capture::TrueSurface truth = torso.patient.true_surface(snapshot.captured);
  std::vector<Vector3d> places;
  for (double x = -0.045; x <= 0.046; x += 0.015)
    for (double y = -0.045; y <= 0.046; y += 0.015)
      if (const auto seen = truth.on_ray_through({torso.spot.at + Vector3d(x, y, 0.0)}); seen.on_body)
        places.push_back(seen.at.m);
  return press_all(snapshot, places, [&](const Vector3d& foot) -> std::optional<Truth> {
    const auto nearest = truth.closest_to({foot});
    if (!nearest) return std::nullopt;
    return Truth{nearest->normal.v, nearest->normal.v.dot(foot - nearest->at.m)};
  });
}

Result<FilmedTorso> film(Result<capture::SyntheticPatient> patient) {
  constexpr int kFrames = 30;
  if (!patient) return patient.error();
  FilmedTorso torso{std::move(patient).value(), {}, {}};
  torso.spot = testing::belly(torso.patient);
  for (int n = 0; n < kFrames; ++n)
    torso.frames.push_back(torso.patient.frame_at(scene_time(n * kFrame_s), static_cast<std::uint64_t>(n)));
  return torso;
}

/// The snapshot after all frames of a torso. A variant without temporal filter gets only the last frame. `times_ms`:
/// duration of each build.
std::shared_ptr<const SurfaceSnapshot> watch(const FilmedTorso& torso, const SurfaceVariant& variant,
                                             Distribution& times_ms) {
  constexpr std::size_t kAlone = 8;
  const Reach reach{{torso.spot.at}, surface::kReach_m};
  VariantStream stream(variant);
  std::shared_ptr<const SurfaceSnapshot> snapshot;
  const std::size_t count = torso.frames.size();
  const double begin_s = spent_s();
  for (std::size_t n = variant.settings.temporal ? 0 : count - kAlone; n < count; ++n) {
    if (!variant.settings.temporal && n + 1 < count && spent_s() - begin_s > kMostSeconds) continue;
    const RgbdFrame& frame = torso.frames[n];
    const double start_us = thread_us();
    snapshot = stream.add(frame.depth, frame.camera.depth, static_cast<double>(n) * kFrame_s, reach);
    times_ms.add(1e-3 * (thread_us() - start_us));
  }
  return snapshot;
}

/// Keeps the smaller of two measured times, because other programs disturbed it less.
void keep_cheaper(SurfaceFigures& figures, const Distribution& build_ms, const Distribution& step_us) {
  figures.build_p50_ms = std::min(figures.build_p50_ms, build_ms.p50());
  figures.build_p99_ms = std::min(figures.build_p99_ms, build_ms.p99());
  figures.step_p50_us = std::min(figures.step_p50_us, step_us.p50());
  figures.step_p99_us = std::min(figures.step_p99_us, step_us.p99());
}

}  // namespace

bool SurfaceFigures::right_enough() const noexcept {
  return 1e6 * shapes.position_m <= kShapeReach_um && shapes.normal_deg <= kShapeReach_deg &&
         1e3 * torso.position_m <= kTorsoReach_mm && torso.normal_deg <= kTorsoReach_deg && jump_um <= kJumpReach_um &&
         shapes.touched == shapes.places && torso.touched == torso.places;
}

namespace {

RenderedShape rendered(std::unique_ptr<testing::AnalyticSurface> shape, double spacing_m) {
  const Intrinsics camera = testing::camera_with_spacing(0.8, spacing_m);
  DepthImage clean = testing::render(*shape, camera, {});
  return {std::move(shape), camera, std::move(clean)};
}

}  // namespace

std::vector<RenderedShape> rendered_shapes(double spacing_m) {
  std::vector<RenderedShape> all;
  for (auto& shape : testing::smooth_shapes()) all.push_back(rendered(std::move(shape), spacing_m));
  return all;
}

RenderedShape rendered_sphere(double spacing_m) { return rendered(std::move(testing::smooth_shapes()[1]), spacing_m); }

std::string touched(const TouchError& error, const std::string& text) {
  if (error.touched == error.places) return text;
  return text + " (" + std::to_string(error.touched) + "/" + std::to_string(error.places) + ")";
}

std::string both(const TouchError& error, double scale) {
  return touched(error, cell(scale * error.position_m) + " / " + cell(error.normal_deg));
}

Result<FilmedTorso> filmed_torso(double sigma_m) { return film(testing::torso({.sigma_m = sigma_m})); }

Result<FilmedTorso> kinect_torso(double above_m, const Intrinsics& camera) {
  const Result<capture::TriangleMesh> mesh = capture::shipped_torso();
  if (!mesh) return mesh.error();
  return film(
      capture::SyntheticPatient::make(*mesh, {.camera = camera, .camera_above_body_m = above_m, .amplitude_m = 0.0}));
}

namespace {

TouchError error_at(const RenderedShape& shape, const SurfaceVariant& variant, const std::vector<Vector3d>& places) {
  const Reach reach{{{0.02, 0.0, 0.82}}, surface::kReach_m};
  VariantStream stream(variant);
  const double start_us = thread_us();
  const auto snapshot = stream.add(shape.clean, shape.camera, 0.0, reach);
  const double build_ms = 1e-3 * (thread_us() - start_us);
  TouchError error = press_all(*snapshot, places, [&](const Vector3d& foot) -> std::optional<Truth> {
    const testing::TrueFoot there = shape.truth->foot(foot);
    return Truth{there.normal, there.distance_m};
  });
  error.build_ms = build_ms;
  return error;
}

}  // namespace

TouchError shape_touch_error(const RenderedShape& shape, const SurfaceVariant& variant) {
  return error_at(shape, variant, places_on(*shape.truth));
}

TouchError slope_touch_error(const RenderedShape& sphere, const SurfaceVariant& variant, double slope_deg) {
  return error_at(sphere, variant, places_at_slope(*sphere.truth, slope_deg));
}

TouchError torso_touch_error(const FilmedTorso& torso, const SurfaceVariant& variant) {
  Distribution build_ms;
  TouchError error = torso_error(torso, *watch(torso, variant, build_ms));
  error.build_ms = build_ms.p50();
  return error;
}

SurfaceFigures measure_surface(const SurfaceVariant& variant, const std::vector<RenderedShape>& shapes,
                               const FilmedTorso& torso) {
  SurfaceFigures figures;
  for (const RenderedShape& shape : shapes) {
    const TouchError error = shape_touch_error(shape, variant);
    figures.shapes.places += error.places;
    figures.shapes.touched += error.touched;
    figures.shapes.position_m = std::max(figures.shapes.position_m, error.position_m);
    figures.shapes.normal_deg = std::max(figures.shapes.normal_deg, error.normal_deg);
  }
  Distribution build_ms;
  const auto snapshot = watch(torso, variant, build_ms);
  figures.torso = torso_error(torso, *snapshot);
  figures.jump_um = jump_um(*snapshot, torso.spot);
  keep_cheaper(figures, build_ms, step_times_us(*snapshot, torso.spot));
  return figures;
}

void measure_cost_again(const SurfaceVariant& variant, const FilmedTorso& torso, SurfaceFigures& figures) {
  Distribution build_ms;
  const auto snapshot = watch(torso, variant, build_ms);
  keep_cheaper(figures, build_ms, step_times_us(*snapshot, torso.spot));
}

}  // namespace telepalp::bench
