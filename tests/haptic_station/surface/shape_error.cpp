#include "tests/haptic_station/surface/shape_error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "haptic_station/surface/touch/touch.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::testing {
namespace {

using Eigen::Vector3d;
using surface::Touch;
using surface::TouchSample;

constexpr double kSteepestView = 0.77;  // cosine of 40 degrees: on a steeper surface the pixels are too far apart
constexpr int kPressSteps = 60;
constexpr int kSettleSteps = 30;

/// Moves from `from` to `to`, pressing, and stays there for a moment.
TouchSample press(const surface::SurfaceSnapshot& snapshot, const Vector3d& from, const Vector3d& to,
                  std::vector<double>& step_us) {
  Touch touch;
  touch.adopt(snapshot, snapshot.captured);
  TouchSample last;
  for (int i = 0; i <= kPressSteps + kSettleSteps; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / kPressSteps);
    const auto start = std::chrono::steady_clock::now();
    last = touch.step({from + share * (to - from)}, snapshot.captured, kTick_s);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    if (last.in_body) step_us.push_back(took.count());
  }
  return last;
}

/// Sums over places, and the root of their means.
class Errors {
 public:
  void add(const TouchSample& sample, const Vector3d& true_normal, double distance_m) {
    ++error_.points;
    error_.position_rms_m += distance_m * distance_m;
    error_.position_max_m = std::max(error_.position_max_m, std::abs(distance_m));
    error_.normal_rms_deg += true_normal.cross(sample.normal).squaredNorm();
  }
  [[nodiscard]] ShapeError total(std::vector<double> step_us) const {
    ShapeError total = error_;
    const double count = std::max(1, total.points);
    total.position_rms_m = std::sqrt(total.position_rms_m / count);
    total.normal_rms_deg = std::sqrt(total.normal_rms_deg / count) * 180.0 / std::numbers::pi;
    if (!step_us.empty()) total.step_us = median_of(step_us);
    return total;
  }

 private:
  ShapeError error_;
};

}  // namespace

std::vector<std::unique_ptr<AnalyticSurface>> smooth_shapes() {
  std::vector<std::unique_ptr<AnalyticSurface>> all;
  all.push_back(plane({0, 0, 0.8}, {0.3, -0.2, -1.0}));
  all.push_back(sphere({0, 0, 0.88}, 0.08));
  all.push_back(sphere({0, 0, 0.85}, 0.05));
  all.push_back(saddle(0.8, 10.0));
  all.push_back(gaussian_bump(0.8, 0.02, 0.04));
  all.push_back(torus({-0.1, 0, 0.85}, 0.1, 0.05));
  return all;
}

ShapeError shape_error(const AnalyticSurface& surface, const surface::SurfaceSettings& settings,
                       const ShapeTrial& trial) {
  const Intrinsics camera = camera_with_spacing(0.8, trial.spacing_m);
  const DepthImage clean = render(surface, camera, {});
  surface::SurfaceBuilder builder(settings);
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  const surface::Reach reach{{{0.02, 0.0, 0.82}}, 0.09};
  for (int frame = 0; frame < trial.frames; ++frame) {
    const RenderSettings noise{.sigma_m = trial.sigma_m, .seed = static_cast<std::uint64_t>(frame + 1)};
    snapshot = builder.add(trial.sigma_m > 0.0 ? with_noise(clean, noise) : clean, camera, scene_time(frame * kFrame_s),
                           reach);
  }
  Errors errors;
  std::vector<double> step_us;
  for (double x = -0.01; x <= 0.05; x += 0.0071)
    for (double y = -0.03; y <= 0.03; y += 0.0071) {
      const Vector3d ray(x / 0.8, y / 0.8, 1.0);
      const double z = surface.depth_along(ray.x(), ray.y());
      if (z == 0.0 || -surface.foot(z * ray).normal.dot(ray.normalized()) < kSteepestView) continue;
      const TouchSample sample = press(*snapshot, 0.97 * z * ray, 1.01 * z * ray, step_us);
      if (!sample.in_body) continue;
      const TrueFoot truth = surface.foot(sample.foot.m);
      errors.add(sample, truth.normal, truth.distance_m);
    }
  return errors.total(step_us);
}

ShapeError torso_error(const capture::SyntheticPatient& patient, const surface::SurfaceSnapshot& snapshot,
                       const Spot& spot) {
  const capture::TrueSurface truth = patient.true_surface(snapshot.captured);
  Errors errors;
  std::vector<double> step_us;
  for (double x = -0.05; x <= 0.05; x += 0.0101)
    for (double y = -0.05; y <= 0.05; y += 0.0101) {
      const auto seen = truth.on_ray_through({spot.at + Vector3d(x, y, 0.0)});
      if (!seen.on_body) continue;
      const TouchSample sample = press(snapshot, 0.97 * seen.at.m, 1.01 * seen.at.m, step_us);
      const auto nearest = truth.closest_to(sample.foot);
      if (!sample.in_body || !nearest) continue;
      errors.add(sample, nearest->normal.v, nearest->normal.v.dot(sample.foot.m - nearest->at.m));
    }
  return errors.total(step_us);
}

}  // namespace telepalp::testing
