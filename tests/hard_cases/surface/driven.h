#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "haptic_station/surface/touch/touch.h"
#include "tests/haptic_station/periods.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/surface/rows.h"

// Short functions for surfaces, and for a device that moves over them.

namespace telepalp::surface {

using Eigen::Vector3d;
using Eigen::Vector3f;
using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using namespace hard_cases;

inline constexpr double kStiffness_N_per_m = 500.0;
inline constexpr double kMostForceStep_N = 0.02;

inline SessionTime at_s(double seconds) { return session_time(0) + from_seconds(seconds); }

using Snapshot = std::shared_ptr<const SurfaceSnapshot>;

inline SurfaceSettings one_frame() { return *surface_settings("single-frame"); }

/// 160×120 pixels 1.5 mm apart at 0.8 m.
inline Intrinsics small_camera() {
  return {.width = 160, .height = 120, .fx = 533.3, .fy = 533.3, .cx = 79.5, .cy = 59.5};
}

inline Snapshot from_depth(const std::function<double(int, int)>& z_m, SessionTime captured = at_s(1.0)) {
  const Intrinsics camera = small_camera();
  DepthImage image{.width = camera.width, .height = camera.height, .unit_m = 2e-5, .samples = {}};
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u)
      image.samples.push_back(static_cast<std::uint16_t>(std::lround(z_m(u, v) / image.unit_m)));
  return build_snapshot(image, camera, captured, std::nullopt, one_frame());
}

inline Snapshot from_shape(const testing::AnalyticSurface& shape) {
  const Intrinsics camera = small_camera();
  return from_depth(
      [&](int u, int v) { return shape.depth_along((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy); });
}

inline Snapshot from_points(std::vector<CloudPoint> points, double support_m = 0.006) {
  CloudShape shape;
  shape.support_m = support_m;
  return std::make_shared<const CloudSnapshot>(std::move(points), shape, Index::Nanoflann);
}

/// 81 × 81 points 1 mm apart at depth `z_m`, facing the camera or away from it.
inline std::vector<CloudPoint> sheet(float z_m, bool to_camera) {
  std::vector<CloudPoint> points;
  for (int j = -40; j <= 40; ++j)
    for (int i = -40; i <= 40; ++i)
      points.push_back({{0.001F * static_cast<float>(i), 0.001F * static_cast<float>(j), z_m},
                        {0.0F, 0.0F, to_camera ? -1.0F : 1.0F}});
  return points;
}

struct Drive {
  TouchSample last;
  double worst_step_N = 0.0;
  double worst_force_N = 0.0;
  bool finite = true;
  bool touched = false;
};

/// Moves a device along `path(t)` from 0 to `until_s`, and adopts the snapshots of `feed`.
inline Drive drive(
    Touch& touch, const std::function<Vector3d(double)>& path, double until_s,
    const std::function<const SurfaceSnapshot*(double)>& feed = [](double) { return nullptr; }, double from_s = 0.0) {
  Drive out;
  Vector3d last_N = Vector3d::Zero();
  for (int tick = 0; tick * kTick_s < until_s; ++tick) {
    const double t = from_s + tick * kTick_s;
    if (const SurfaceSnapshot* newest = feed(t)) touch.adopt(*newest, at_s(1.0 + t));
    const Vector3d at = path(t);
    out.last = touch.step({at}, at_s(1.0 + t), kTick_s);
    const Vector3d force_N = kStiffness_N_per_m * (out.last.proxy.m - at);
    out.finite = out.finite && force_N.allFinite() && out.last.normal.allFinite() && std::isfinite(out.last.distance_m);
    if (tick > 0) out.worst_step_N = std::max(out.worst_step_N, (force_N - last_N).norm());
    out.worst_force_N = std::max(out.worst_force_N, force_N.norm());
    out.touched = out.touched || out.last.in_body;
    last_N = force_N;
  }
  return out;
}

/// From `from` to `to` in `seconds`.
inline std::function<Vector3d(double)> line(const Vector3d& from, const Vector3d& to, double seconds) {
  return [=](double t) -> Vector3d { return from + std::min(1.0, t / seconds) * (to - from); };
}

inline Drive drive_on(const Snapshot& snapshot, const std::function<Vector3d(double)>& path, double until_s) {
  Touch touch;
  touch.adopt(*snapshot, at_s(1.0));
  return drive(touch, path, until_s);
}

}  // namespace telepalp::surface
