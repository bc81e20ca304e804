#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "haptic_station/surface/cloud_snapshot.h"
#include "haptic_station/surface/paper_surface.h"
#include "haptic_station/surface/surface_builder.h"
#include "haptic_station/surface/touch.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using namespace hard_cases;
using ::testing::AssertionFailure;
using ::testing::AssertionResult;

constexpr double kTick_s = 0.0005;
constexpr double kStiffness_N_per_m = 500.0;
constexpr double kMostForceStep_N = 0.02;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

SessionTime at_s(double seconds) { return session_time(0) + from_seconds(seconds); }

using Snapshot = std::shared_ptr<const SurfaceSnapshot>;

SurfaceSettings one_frame() { return *surface_settings("single-frame"); }

/// 160×120 pixels 1.5 mm apart at 0.8 m.
Intrinsics small_camera() { return {.width = 160, .height = 120, .fx = 533.3, .fy = 533.3, .cx = 79.5, .cy = 59.5}; }

Snapshot from_depth(const std::function<double(int, int)>& z_m, SessionTime captured = at_s(1.0)) {
  const Intrinsics camera = small_camera();
  DepthImage image{.width = camera.width, .height = camera.height, .unit_m = 2e-5, .samples = {}};
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u)
      image.samples.push_back(static_cast<std::uint16_t>(std::lround(z_m(u, v) / image.unit_m)));
  return build_snapshot(image, camera, captured, std::nullopt, one_frame());
}

Snapshot from_shape(const testing::AnalyticSurface& shape) {
  const Intrinsics camera = small_camera();
  return from_depth(
      [&](int u, int v) { return shape.depth_along((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy); });
}

Snapshot from_points(std::vector<CloudPoint> points, double support_m = 0.006) {
  CloudShape shape;
  shape.support_m = support_m;
  return std::make_shared<const CloudSnapshot>(std::move(points), shape, Index::Nanoflann);
}

/// 81 × 81 points 1 mm apart at depth `z_m`, facing the camera or away from it.
std::vector<CloudPoint> sheet(float z_m, bool to_camera) {
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

/// Moves a device along `path(t)` from 0 to `until_s`, adopting what `feed` has at each instant.
Drive drive(
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
std::function<Vector3d(double)> line(const Vector3d& from, const Vector3d& to, double seconds) {
  return [=](double t) -> Vector3d { return from + std::min(1.0, t / seconds) * (to - from); };
}

Drive drive_on(const Snapshot& snapshot, const std::function<Vector3d(double)>& path, double until_s) {
  Touch touch;
  touch.adopt(*snapshot, at_s(1.0));
  return drive(touch, path, until_s);
}

AssertionResult nothing_there() {
  const Snapshot none = from_depth([](int, int) { return 0.0; });
  const Drive drove = drive_on(none, line({0, 0, 0.7}, {0, 0, 0.9}, 0.1), 0.1);
  return all_of({{drove.finite, "finite"}, {!drove.last.valid, "not valid"}, {drove.worst_force_N == 0.0, "no force"}});
}

AssertionResult points_in_one_place() {
  const Snapshot heap = from_points(std::vector<CloudPoint>(100, {{0.0F, 0.0F, 0.8F}, {0.0F, 0.0F, -1.0F}}));
  const Drive drove = drive_on(heap, line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const std::vector<Vector3f> bare(100, Vector3f(0.0F, 0.0F, 0.8F));
  return all_of({{drove.finite, "finite"},
                 below_N("force bounded", drove.worst_force_N, 0.01 * kStiffness_N_per_m),
                 {with_normals(bare, 10, Vector3f::Zero()).empty(), "no normal is made up"}});
}

AssertionResult points_on_a_line() {
  IndexedPoints points;
  for (int i = -50; i <= 50; ++i) points.at_m.emplace_back(0.001F * static_cast<float>(i), 0.0F, 0.8F);
  const PaperSurface paper(points, *surface_settings("paper-nanoflann"));
  const FieldSample sample = paper.evaluate({0.0, 0.0, 0.79}, Vector3d::Zero(), {});
  return all_of({{sample.valid, "valid"},
                 {sample.normal.z() < -0.99, "the view ray stands in for the normal"},
                 {with_normals(points.at_m, 10, Vector3f::Zero()).empty(), "the default leaves the points out"}});
}

AssertionResult points_on_a_plane() {
  const Snapshot flat = from_points(sheet(0.8F, true));
  double worst = 0.0;
  for (int i = -40; i <= 40; ++i) {
    const Vector3d at(0.0002 * i, 0.0001 * i, 0.8 + 0.00005 * i);
    worst = std::max(worst, std::abs(flat->evaluate(at, Vector3d::Zero(), {}).f_m + 0.00005 * i));
  }
  const auto tilted = testing::plane({0, 0, 0.8}, {0.3, -0.2, -1.0});
  const Snapshot grid = from_shape(*tilted);
  double worst_grid = 0.0;
  for (int i = -40; i <= 40; ++i) {
    const Vector3d at(0.0003 * i, -0.0002 * i, 0.8 + 0.0001 * i);
    worst_grid =
        std::max(worst_grid, std::abs(grid->evaluate(at, Vector3d::Zero(), {}).f_m - tilted->foot(at).distance_m));
  }
  return all_of({below_m("f is linear on points", worst, 1e-7),
                 below_m("f is linear on a depth image, to its rounding", worst_grid, 5e-6)});
}

Snapshot plane_with_hole(int half_side_px) {
  return from_depth([=](int u, int v) {
    const bool hole = std::abs(u - 80) <= half_side_px && std::abs(v - 60) <= half_side_px;
    return hole ? 0.0 : 0.8;
  });
}

AssertionResult holes() {
  const Drive small = drive_on(plane_with_hole(1), line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const Drive large = drive_on(plane_with_hole(25), line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const Drive across = drive_on(plane_with_hole(25), line({-0.07, 0, 0.803}, {0, 0, 0.803}, 1.0), 1.0);
  return all_of({{small.last.in_body && std::abs(small.last.proxy.m.z() - 0.8) < 1e-4, "a small hole is bridged"},
                 {!large.touched && large.finite, "a large one is no contact"},
                 below_N("sliding into it lets go without a step", across.worst_step_N, kMostForceStep_N)});
}

AssertionResult silhouette() {
  const Snapshot step = from_depth([](int u, int) { return u < 80 ? 0.77 : 0.8; });
  double worst = 0.0;
  for (int px = 2; px < 12; ++px)
    for (const int side : {-1, 1}) {
      const double z = side < 0 ? 0.77 : 0.8;
      const double x = (side < 0 ? -px : px) * z / 533.3;
      const Drive drove = drive_on(step, line({x, 0, z - 0.004}, {x, 0, z + 0.003}, 0.1), 0.15);
      if (drove.last.in_body) worst = std::max(worst, std::abs(drove.last.foot.m.z() - z));
    }
  return all_of({below_m("no surface between the layers", worst, 2e-4)});
}

AssertionResult thin_sheet() {
  std::vector<CloudPoint> both = sheet(0.8F, true);
  for (const CloudPoint& back : sheet(0.803F, false)) both.push_back(back);
  const Snapshot skin = from_points(std::move(both));
  const Drive front = drive_on(skin, line({0, 0, 0.79}, {0, 0, 0.815}, 0.2), 0.4);
  const Drive behind = drive_on(skin, line({0, 0, 0.815}, {0, 0, 0.79}, 0.2), 0.4);
  return all_of({{front.last.in_body && std::abs(front.last.proxy.m.z() - 0.8) < 2e-4, "held on the front"},
                 {behind.last.in_body && std::abs(behind.last.proxy.m.z() - 0.803) < 2e-4, "held on the back"}});
}

AssertionResult concave_crease() {
  const auto valley = testing::crease(0.8, 0.8);  // |x| rises towards the camera on both sides
  const Snapshot snapshot = from_shape(*valley);
  Touch touch;
  touch.adopt(*snapshot, at_s(1.0));
  const auto path = [](double t) {
    return Vector3d(0.004 * std::sin(20.0 * t), 0.0, 0.79 + 0.025 * std::min(1.0, t / 0.3));
  };
  const Drive slid = drive(touch, path, 0.6);
  const Drive held = drive(
      touch, [&](double) { return path(0.6); }, 0.1, [](double) { return nullptr; }, 0.6);
  const Drive still = drive(
      touch, [&](double) { return path(0.6); }, 0.2, [](double) { return nullptr; }, 0.7);
  return all_of({{slid.finite && slid.last.in_body, "in contact"},
                 {held.last.in_body, "held"},
                 below_N("no chatter at rest", still.worst_step_N, 1e-3),
                 below_N("no jump from wall to wall", slid.worst_step_N, 0.3)});
}

AssertionResult vanishing_gradient() {
  std::vector<CloudPoint> ball;  // 4 mm radius, all of it within the support of its centre
  for (int i = 0; i < 400; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / 400.0;
    const double turn = i * 2.399963;
    const Vector3d n(std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z);
    ball.push_back({(Vector3d(0, 0, 0.8) + 0.004 * n).cast<float>(), n.cast<float>()});
  }
  const Drive drove = drive_on(from_points(std::move(ball), 0.008), line({0, 0, 0.79}, {0, 0, 0.8}, 0.2), 0.4);
  return all_of({{drove.finite, "finite"},
                 {std::abs(drove.last.normal.norm() - 1.0) < 1e-6, "the last plane holds"},
                 below_N("force bounded", drove.worst_force_N, 0.012 * kStiffness_N_per_m)});
}

AssertionResult rim_of_support() {
  const Snapshot half = from_depth([](int u, int) { return u < 80 ? 0.8 : 0.0; });
  const Drive drove = drive_on(half, line({-0.03, 0, 0.803}, {0.03, 0, 0.803}, 1.0), 1.2);
  double worst = 0.0;
  double last = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double support = half->evaluate({-0.02 + 1e-5 * i, 0.0, 0.8}, Vector3d::Zero(), {}).support;
    if (i > 0) worst = std::max(worst, std::abs(support - last));
    last = support;
  }
  return all_of({{drove.finite && drove.touched && !drove.last.in_body, "contact ends beyond the rim"},
                 below_N("without a step", drove.worst_step_N, kMostForceStep_N),
                 {worst < 0.01, "support fades smoothly"}});
}

AssertionResult neighbours_change() {
  std::mt19937_64 random(3);
  std::normal_distribution<float> noise(0.0F, 0.001F);
  std::vector<CloudPoint> points = sheet(0.8F, true);
  for (CloudPoint& point : points) point.at_m.z() += noise(random);
  const Snapshot rough = from_points(std::move(points));
  const Snapshot grid = from_depth([&](int, int) { return 0.8 + static_cast<double>(noise(random)); });
  double worst = 0.0;
  for (const Snapshot& snapshot : {rough, grid}) {
    double last = snapshot->evaluate({-0.01, 0.0031, 0.8}, {0, 0, -1}, {}).f_m;
    for (int i = 1; i < 20000; ++i) {
      const double f = snapshot->evaluate({-0.01 + 1e-6 * i, 0.0031, 0.8}, {0, 0, -1}, {}).f_m;
      worst = std::max(worst, std::abs(f - last));
      last = f;
    }
  }
  return all_of({below_m("f changes by at most 2 um over 1 um", worst, 2e-6)});
}

AssertionResult flipped_normal() {
  std::vector<CloudPoint> points = sheet(0.8F, true);
  for (std::size_t i = 0; i < points.size(); i += 29) points[i].normal = -points[i].normal;
  const Drive drove = drive_on(from_points(std::move(points)), line({0, 0, 0.79}, {0.004, 0, 0.805}, 0.2), 0.4);
  return all_of({{drove.last.in_body, "in contact"},
                 below_m("on the surface", std::abs(drove.last.proxy.m.z() - 0.8), 2e-4),
                 {drove.last.normal.z() < -0.999, "the many outvote the few"}});
}

AssertionResult fast_entry() {
  const auto bump = testing::gaussian_bump(0.8, 0.02, 0.04);
  const Snapshot snapshot = from_shape(*bump);
  for (const double speed_m_per_s : {0.5, 2.0, 20.0, 1e4}) {
    const Vector3d from(0.01, 0.0, 0.70);
    const Vector3d to(0.01, 0.0, 0.81);
    const double seconds = std::max(kTick_s, (to - from).norm() / speed_m_per_s);
    const Drive drove = drive_on(snapshot, line(from, to, seconds), seconds + 0.01);
    const testing::TrueFoot truth = bump->foot(drove.last.proxy.m);
    if (!drove.last.in_body || std::abs(truth.distance_m) > 1e-4)
      return AssertionFailure() << "tunnelled at " << speed_m_per_s << " m/s";
  }
  return all_of({{true, "held at 0.5, 2, 20 and 10000 m/s"}});
}

/// The outer shell of a torus whose tube is wider than its ring, seen by points that know their normals.
std::vector<CloudPoint> spindle() {
  std::vector<CloudPoint> points;
  constexpr double kRing = 0.01;
  constexpr double kTube = 0.02;
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 120; ++j) {
      const double a = 2.0 * M_PI * i / 120.0;
      const double b = 2.0 * M_PI * j / 120.0;
      const double across = kRing + kTube * std::cos(b);
      if (across < 0.0) continue;  // inside the union
      points.push_back({Vector3d(across * std::cos(a), across * std::sin(a), 0.8 + kTube * std::sin(b)).cast<float>(),
                        Vector3d(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)).cast<float>()});
    }
  return points;
}

AssertionResult spindle_torus() {
  const Drive side = drive_on(from_points(spindle()), line({0.05, 0, 0.8}, {0.02, 0, 0.8}, 0.2), 0.4);
  return all_of({{side.last.in_body, "in contact"},
                 below_m("on the outer shell", std::abs(side.last.proxy.m.x() - 0.03), 3e-4),
                 {side.last.normal.x() > 0.99, "normal outwards"}});
}

AssertionResult on_the_axis() {
  const Snapshot shell = from_points(spindle());
  const Drive first = drive_on(shell, line({0, 0, 0.75}, {0, 0, 0.8}, 0.2), 0.4);
  const Drive again = drive_on(shell, line({0, 0, 0.75}, {0, 0, 0.8}, 0.2), 0.4);
  return all_of({{first.finite, "finite"},
                 {first.last.normal == again.last.normal, "the same every time"},
                 {first.last.proxy.m == again.last.proxy.m, "the same proxy"}});
}

DepthImage flat_image(double z_m) {
  const Intrinsics camera = small_camera();
  return {.width = camera.width,
          .height = camera.height,
          .unit_m = 2e-5,
          .samples = std::vector<std::uint16_t>(static_cast<std::size_t>(camera.width * camera.height),
                                                static_cast<std::uint16_t>(std::lround(z_m / 2e-5)))};
}

AssertionResult clock_jumps() {
  SurfaceBuilder builder{SurfaceSettings{}};
  const DepthImage image = flat_image(0.8);
  const auto first = builder.add(image, small_camera(), at_s(10.0), std::nullopt);
  const bool duplicate = builder.add(image, small_camera(), at_s(10.0), std::nullopt) == nullptr;
  const bool older = builder.add(image, small_camera(), at_s(9.9), std::nullopt) == nullptr;
  Touch touch;
  touch.adopt(*first, at_s(10.0));
  bool finite = true;
  for (const double t : {10.1, 9.0, 10.2, -5.0})
    finite = finite && touch.step({{0, 0, 0.803}}, at_s(t), t < 10 ? -1.0 : 0.0005).proxy.m.allFinite();
  return all_of({{duplicate && older && builder.counts().not_newer == 2, "dropped and counted"}, {finite, "finite"}});
}

/// A flat patient that breathes ±2.5 mm at 0.25 Hz, seen at 30 Hz with its stamps `jitter_s` off.
Drive breathe(double jitter_s, const std::function<bool(double)>& outage, double until_s) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> jitter(-jitter_s, jitter_s);
  SurfaceBuilder builder{SurfaceSettings{}};
  Snapshot current;
  int next = 0;
  Touch touch;
  const auto feed = [&](double t) -> const SurfaceSnapshot* {
    if (t * 30.0 < next) return nullptr;
    next = static_cast<int>(t * 30.0) + 1;
    if (outage(t)) return nullptr;
    const DepthImage image = flat_image(0.8 + 0.0025 * std::cos(0.5 * M_PI * t));
    if (auto built = builder.add(image, small_camera(), at_s(1.0 + t + jitter(random)), std::nullopt)) current = built;
    return current.get();
  };
  return drive(
      touch, [](double t) { return Vector3d(0, 0, 0.78 + 0.03 * std::min(1.0, 2.0 * t)); }, until_s, feed);
}

AssertionResult jittered_frames() {
  const Drive drove = breathe(
      0.004, [](double) { return false; }, 6.0);
  return all_of({{drove.finite && drove.last.in_body, "in contact"},
                 below_N("no step beyond the hand's own motion", drove.worst_step_N, 0.04)});
}

AssertionResult swap_in_contact() {
  const Snapshot before = from_depth([](int, int) { return 0.8; });
  const Snapshot after = from_depth([](int, int) { return 0.797; }, at_s(1.3));
  Touch touch;
  touch.adopt(*before, at_s(1.0));
  const Drive sunk = drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.2), 0.3);
  bool adopted = false;
  const auto feed = [&](double) { return std::exchange(adopted, true) ? nullptr : after.get(); };
  const Drive swapped = drive(
      touch, [](double) { return Vector3d(0, 0, 0.805); }, 1.0, feed, 0.3);
  return all_of({{sunk.last.in_body, "in contact"},
                 below_N("slewed", swapped.worst_step_N, kMostForceStep_N),
                 below_m("and it arrives", std::abs(swapped.last.proxy.m.z() - 0.797), 2e-5)});
}

AssertionResult burst() {
  std::vector<Snapshot> queued;
  for (int i = 0; i < 15; ++i)
    queued.push_back(from_depth([=](int, int) { return 0.8 - 0.0002 * i; }, at_s(1.0 + 0.033 * i)));
  Touch touch;
  touch.adopt(*queued.front(), at_s(1.0));
  (void)drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.2), 0.5);
  bool came = false;
  const auto feed = [&](double t) -> const SurfaceSnapshot* {
    if (std::exchange(came, true)) return nullptr;
    for (const Snapshot& one : queued) touch.adopt(*one, at_s(1.0 + t));
    return nullptr;
  };
  const Drive after = drive(
      touch, [](double) { return Vector3d(0, 0, 0.805); }, 0.7, feed, 0.5);
  return all_of({below_N("no step", after.worst_step_N, kMostForceStep_N),
                 below_m("only the newest counts", std::abs(after.last.proxy.m.z() - (0.8 - 0.0028)), 2e-5)});
}

AssertionResult outage() {
  const Snapshot only = from_depth([](int, int) { return 0.8; });
  Touch touch;
  touch.adopt(*only, at_s(1.0));
  const Drive drove = drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.2), 3.0);
  return all_of({{drove.touched, "was in contact"},
                 {!drove.last.valid && (drove.last.proxy.m - Vector3d(0, 0, 0.805)).norm() == 0.0, "has let go"},
                 below_N("without a step", drove.worst_step_N, kMostForceStep_N)});
}

AssertionResult far_from_the_origin() {
  CloudShape shape;
  shape.support_m = 0.006;
  shape.origin_m = Vector3d(12345.0, -54321.0, 9999.2);
  const Snapshot far = std::make_shared<const CloudSnapshot>(sheet(0.8F, true), shape, Index::Nanoflann);
  double worst = 0.0;
  for (int i = -20; i <= 20; ++i)
    worst = std::max(
        worst,
        std::abs(far->evaluate(shape.origin_m + Vector3d(1e-4 * i, 0, 0.8 + 1e-5 * i), Vector3d::Zero(), {}).f_m +
                 1e-5 * i));
  return all_of({below_m("f exact to 0.1 um", worst, 1e-7)});
}

AssertionResult device_that_is_no_number() {
  const Snapshot flat = from_depth([](int, int) { return 0.8; });
  Touch touch;
  touch.adopt(*flat, at_s(1.0));
  (void)drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const TouchSample lost = touch.step({Vector3d::Constant(std::nan(""))}, at_s(1.2), kTick_s);
  const TouchSample back = touch.step({Vector3d(0, 0, 0.805)}, at_s(1.2005), kTick_s);
  return all_of({{!lost.valid && !lost.in_body && lost.proxy.m.allFinite(), "no answer, no NaN"},
                 {back.in_body, "contact goes on"}});
}

AssertionResult starts_in_the_body() {
  const Snapshot flat = from_depth([](int, int) { return 0.8; });
  const Drive shallow = drive_on(
      flat, [](double) { return Vector3d(0, 0, 0.81); }, 0.9);
  const Drive deep = drive_on(
      flat, [](double) { return Vector3d(0, 0, 0.9); }, 0.3);
  return all_of({below_N("the force grows from nothing", shallow.worst_step_N, kMostForceStep_N),
                 below_m("to all of it", std::abs(shallow.last.proxy.m.z() - 0.8), 1e-4),
                 {deep.worst_force_N == 0.0, "far behind is not in"}});
}

AssertionResult shadow_of_an_arm() {
  const Snapshot arm = from_depth([](int u, int) { return std::abs(u - 80) < 20 ? 0.77 : 0.8; });
  const Drive under = drive_on(arm, line({-0.08, 0, 0.785}, {0.08, 0, 0.785}, 0.4), 0.4);
  return all_of(
      {{under.finite, "finite"}, {under.worst_force_N == 0.0, "passing behind a silhouette is not going through it"}});
}

AssertionResult at_the_camera() {
  const Snapshot flat = from_depth([](int, int) { return 0.8; });
  const Drive drove = drive_on(flat, line({0, 0, 0.3}, {0, 0, -0.5}, 0.4), 0.4);
  return all_of({{drove.finite, "finite"}, {!drove.touched, "no contact"}, {drove.worst_force_N == 0.0, "no force"}});
}

AssertionResult a_sliver() {
  const Snapshot sliver = from_depth([](int u, int) { return u == 80 ? 0.8 : 0.0; });
  const Drive drove = drive_on(sliver, line({0, 0, 0.79}, {0.0003, 0, 0.81}, 0.2), 0.3);
  const Drive across = drive_on(sliver, line({-0.02, 0, 0.803}, {0.02, 0, 0.803}, 0.3), 0.3);
  return all_of(
      {{drove.finite && across.finite, "finite"}, {!drove.touched && !across.touched, "no surface is made up"}});
}

const HardCase kHardCases[] = {
    {"1 empty neighbourhood", "every mean divides by no weight", "outside, zero force, no NaN", nothing_there},
    {"2 coincident points", "they span no plane", "no normal made up; bounded", points_in_one_place},
    {"3 collinear points", "a plane may turn about them", "the view ray, or left out", points_on_a_line},
    {"4 coplanar points", "any error shows", "exact plane, f linear", points_on_a_plane},
    {"5 depth hole", "zero is not a depth", "small bridged, large no contact, no step", holes},
    {"6 silhouette", "neighbours in the image, strangers in space", "no surface between the layers", silhouette},
    {"7 thin sheet", "both sides are near", "stays on the entry side", thin_sheet},
    {"8 concave crease", "two planes want the proxy", "two constraints, no chatter", concave_crease},
    {"9 medial axis", "the gradient vanishes", "the last valid plane holds", vanishing_gradient},
    {"10 rim of the support", "weights go to zero", "C1, no 0/0, contact ends without a step", rim_of_support},
    {"11 neighbours change", "the paper's f jumps by 269 um", "no force step", neighbours_change},
    {"12 flipped normals", "a mean of opposites", "oriented by camera and previous", flipped_normal},
    {"13 fast entry", "the surface lies between two ticks", "swept: no tunnelling, up to a teleport", fast_entry},
    {"14 torus, tube wider than ring", "it meets itself", "point on the outer shell", spindle_torus},
    {"15 on the torus' axis", "every direction is as near", "finite and deterministic", on_the_axis},
    {"20 clock jump, duplicate", "time goes back", "dropped, counted, monotone", clock_jumps},
    {"21 jittered frames", "velocities from wrong intervals", "bounded, no step", jittered_frames},
    {"22 surface swap in contact", "a jump is energy into the hand", "slewed, and it arrives", swap_in_contact},
    {"23 burst after an outage", "old frames come late", "newest only, no step", burst},
    {"24 outage", "an old surface is a guess", "age-limited, decays to zero", outage},
    {"32 far from the origin", "floats cancel", "local frame, exact", far_from_the_origin},
    {"33 device that is no number", "NaN spreads", "not valid, no NaN, contact goes on", device_that_is_no_number},
    {"34 start in the body", "force out of nothing", "grows from zero; deep behind is not in", starts_in_the_body},
    {"35 behind a silhouette", "the shadow is not body", "no contact sideways", shadow_of_an_arm},
    {"36 device at the camera, and behind", "the image plane folds over", "no contact, no NaN", at_the_camera},
    {"37 surface one pixel wide", "a line has no normal", "no surface made up", a_sliver},
};

class SurfaceHardCases : public HardCaseTable {};

TEST_P(SurfaceHardCases, DoesWhatItMust) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, SurfaceHardCases, ::testing::ValuesIn(kHardCases), name_of);

}  // namespace
}  // namespace telepalp::surface
