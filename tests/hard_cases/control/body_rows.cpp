#include <functional>
#include <memory>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "proto/words/smooth_step.h"
#include "support/sensor/depth_sensor.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/loop_scene.h"
#include "tests/hard_cases/control/rows.h"

// Objects inside the body, under a skin that a camera sees move.

namespace telepalp::hard_cases {
namespace {

using Eigen::Vector3d;
using ::testing::AssertionResult;

constexpr Intrinsics kCamera{320, 240, 525.0, 525.0, 159.5, 119.5};
constexpr double kCamera_m = 0.8;  // above the skin at rest
constexpr double kFrame_hz = 30.0;
constexpr std::size_t kSphere = 1;  // its number in the bank

Transform<HapticBase, DepthCamera> placed() {
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  haptic_from_camera.iso.linear() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  haptic_from_camera.iso.translation() = Vector3d{0.0, kCamera_m, 0.0};
  return haptic_from_camera;
}

/// A trunk with ribs and hollows.
double shaped(double x_m, double z_m) {
  return 0.006 * std::sin(x_m / 0.016) * std::cos(z_m / 0.02 + 0.4) - x_m * x_m / 1.2 - z_m * z_m / 0.5;
}
/// A trunk that looks the same wherever it lies.
double smooth(double x_m, double z_m) { return -x_m * x_m / 1.2 - z_m * z_m / 0.5; }

/// A sphere whose top lies 30 mm under the skin of a body that moves, and a device that nothing moves.
struct BodyScene {
  double seconds = 5.0;
  std::function<double(double x_m, double z_m)> skin = shaped;
  std::function<Vector3d(double now_s)> body = [](double) { return Vector3d::Zero(); };  ///< displacement in H
  std::function<bool(double now_s)> hidden = [](double) { return false; };  ///< something is over the object's skin
  Vector3d device_m{0.0, 0.06, 0.0};
  std::function<void(const loop::HapticLoop&, const loop::TickOut&, double now_s)> watch = [](const auto&, const auto&,
                                                                                              double) {};
};

DepthImage seen_of(const BodyScene& scene, double now_s, const sensor::DepthSensor& camera) {
  DepthImage depth{.width = kCamera.width, .height = kCamera.height, .unit_m = camera.settings().unit_m, .samples = {}};
  const sensor::Exposure exposure = camera.expose(to_nanoseconds(at_s(now_s)));
  const Vector3d body_m = scene.body(now_s);
  const bool hidden = scene.hidden(now_s);
  std::uint32_t pixel = 0;
  for (int v = 0; v < kCamera.height; ++v)
    for (int u = 0; u < kCamera.width; ++u) {
      const double x = (u - kCamera.cx) / kCamera.fx;
      const double y = (v - kCamera.cy) / kCamera.fy;
      double z_m = kCamera_m;
      for (int step = 0; step < 5; ++step)
        z_m = kCamera_m - body_m.y() - scene.skin(x * z_m - body_m.x(), y * z_m - body_m.z());
      if (hidden && std::hypot(u - kCamera.cx, v - kCamera.cy) < 40.0) z_m = 0.7;
      depth.samples.push_back(exposure.sample(static_cast<float>(z_m), pixel++));
    }
  return depth;
}

void run(const BodyScene& scene) {
  effects::EffectBank bank = the_skin({.law = effects::linear_law(100.0)});
  (void)bank.add(effects::InnerSphere({.center = {{0.0, -0.05, 0.0}}}));
  loop::HapticLoop loop({}, control::EncounteredController({}, bank));
  surface::SurfaceBuilder builder{surface::SurfaceSettings{}};
  builder.watch(loop::mark_lines(bank, placed().inverse()));
  const sensor::DepthSensor camera({});
  ShownSurface shown;
  int frames = 0;
  const Point<HapticBase> above{{scene.device_m.x(), 0.06, scene.device_m.z()}};
  for (int tick = 0; tick * LoopScene::kTick_s < scene.seconds; ++tick) {
    const double now_s = tick * LoopScene::kTick_s;
    const double down = smooth_step(now_s - 0.7);
    const Point<HapticBase> device{above.m + down * (scene.device_m - above.m)};
    loop::TickIn in{.now = at_s(now_s), .dt_s = LoopScene::kTick_s, .reading = {.at = device, .velocity = {}}};
    if (now_s * kFrame_hz >= frames) {
      ++frames;
      auto newer = builder.add(seen_of(scene, now_s, camera), kCamera, at_s(now_s),
                               surface::Reach{placed().inverse() * device, surface::kReach_m});
      if (newer) in.surface = shown.show({std::move(newer), placed()});
    }
    if (tick % LoopScene::kTicksPerSample == 0) in.hand = {at_s(now_s), device};
    const loop::TickOut out = loop.tick(in);
    scene.watch(loop, out, now_s);
  }
}

/// By how far the sphere is displayed beside its place in the body, at the worst, and what was said of it.
struct Followed {
  double off_m = 0.0;
  double off_sideways_m = 0.0;
  double off_across_m = 0.0;
  double unseen_share = 0.0;
  double slide_unseen_share = 0.0;
};

/// Judged in the last half second of each of the plateaus, which last `plateau_s` from 1 s on.
Followed follow(BodyScene scene, double plateau_s) {
  Followed got;
  int ticks = 0;
  scene.watch = [&](const loop::HapticLoop& loop, const loop::TickOut&, double now_s) {
    const double since_s = now_s - 1.0;
    if (since_s < 0.0 || std::fmod(since_s, plateau_s) < plateau_s - 0.5) return;
    const loop::ObjectPlacement sphere = loop.objects()[kSphere];
    const Eigen::Vector3f moved(sphere.moved.data());
    const Vector3d off = moved.cast<double>() - scene.body(now_s);
    got.off_m = std::max(got.off_m, off.norm());
    got.off_across_m = std::max(got.off_across_m, std::abs(off.y()));
    got.off_sideways_m = std::max(got.off_sideways_m, double{std::hypot(moved.x(), moved.z())});
    got.unseen_share += sphere.unseen ? 1.0 : 0.0;
    got.slide_unseen_share += sphere.slide_unseen ? 1.0 : 0.0;
    ++ticks;
  };
  run(scene);
  got.unseen_share /= ticks;
  got.slide_unseen_share /= ticks;
  return got;
}

AssertionResult under_a_skin_that_moves() {
  BodyScene scene{.seconds = 7.0};
  scene.body = [](double now_s) {
    return Vector3d(
        0.0,
        -0.01 * smooth_step(now_s - 1.0) + 0.03 * smooth_step((now_s - 3.0) / 1.2) - 0.02 * smooth_step(now_s - 5.0),
        0.0);
  };
  const Followed got = follow(scene, 2.0);
  return all_of({below("beside its place", got.off_m, 0.002, 1e3, "mm"),
                 {got.unseen_share == 0.0 && got.slide_unseen_share == 0.0, "seen throughout"}});
}

AssertionResult body_that_slides() {
  BodyScene scene{.seconds = 5.0};
  scene.body = [](double now_s) {
    return Vector3d(0.02 * smooth_step(now_s - 1.0), 0.005 * smooth_step(now_s - 1.0),
                    -0.02 * smooth_step(now_s - 3.0));
  };
  const Followed got = follow(scene, 2.0);
  return all_of({below("beside its place", got.off_m, 0.003, 1e3, "mm"),
                 {got.unseen_share == 0.0 && got.slide_unseen_share == 0.0, "seen throughout"}});
}

/// Nothing tells a slide of a smooth trunk: the object must not wander with the noise, but must still go up and down.
AssertionResult smooth_body_that_slides() {
  BodyScene scene{.seconds = 5.0, .skin = smooth};
  scene.body = [](double now_s) {
    return Vector3d(0.02 * smooth_step(now_s - 1.0), 0.01 * smooth_step(now_s - 1.0), 0.0);
  };
  const Followed got = follow(scene, 2.0);
  return all_of({{got.slide_unseen_share == 1.0, "flagged: slide not seen"},
                 {got.unseen_share == 0.0, "its rise is seen"},
                 below("rise beside the true one", got.off_across_m, 0.002, 1e3, "mm"),
                 below("wanders sideways", got.off_sideways_m, 0.001, 1e3, "mm")});
}

/// A hand lies over the object's skin while the body rises.
AssertionResult hidden_from_the_camera() {
  BodyScene scene{.seconds = 7.0};
  scene.body = [](double now_s) { return Vector3d(0.0, 0.01 * smooth_step((now_s - 3.2) / 0.8), 0.0); };
  scene.hidden = [](double now_s) { return now_s > 3.0 && now_s < 5.0; };
  double hidden_m = 0.0;
  double back_off_m = 0.0;
  int said = 0;
  int ticks = 0;
  scene.watch = [&](const loop::HapticLoop& loop, const loop::TickOut&, double now_s) {
    const loop::ObjectPlacement sphere = loop.objects()[kSphere];
    const Eigen::Vector3f moved(sphere.moved.data());
    if (now_s > 3.2 && now_s < 4.9) {
      hidden_m = std::max(hidden_m, double{moved.norm()});
      said += sphere.unseen ? 1 : 0;
      ++ticks;
    }
    if (now_s > 6.5) back_off_m = std::max(back_off_m, (moved.cast<double>() - scene.body(now_s)).norm());
  };
  run(scene);
  return all_of({{said == ticks, "flagged: unseen"},
                 below("moves meanwhile", hidden_m, 0.002, 1e3, "mm"),
                 below("beside its place after 1.5 s", back_off_m, 0.002, 1e3, "mm")});
}

/// The device rests 5 mm in the sphere while the body rises by 10 mm: the force must grow as smoothly as the skin.
AssertionResult felt_under_a_skin_that_moves() {
  BodyScene scene{.seconds = 5.0, .device_m = {0.0, -0.034, 0.0}};
  scene.body = [](double now_s) { return Vector3d(0.0, 0.01 * smooth_step(now_s - 3.0), 0.0); };
  double step_N = 0.0;
  double before_N = 0.0;
  double after_N = 0.0;
  Vector3d last_N = Vector3d::Zero();
  scene.watch = [&](const loop::HapticLoop&, const loop::TickOut& act, double now_s) {
    if (now_s > 2.5) step_N = std::max(step_N, (act.force.N - last_N).norm());
    last_N = act.force.N;
    if (now_s > 2.8 && now_s < 3.0) before_N = act.force.N.y();
    if (now_s > 3.0) after_N = std::max(after_N, act.force.N.y());
  };
  run(scene);
  // The skin of 100 N/m gives 1 N more, the sphere of 800 N/m 8 N more, of which the device's peak leaves 3 N.
  return all_of({below_N("step", step_N, 0.1), above("force grows by", after_N - before_N, 2.5, 1.0, "N")});
}

}  // namespace

std::vector<HardCase> body_rows() {
  return {
      {"object: skin moves -10 to +20 mm", "the scene gives its place in the room", "within 2 mm of its place",
       under_a_skin_that_moves},
      {"object: body slides 20 mm", "depth hardly changes", "within 3 mm of its place", body_that_slides},
      {"object: a smooth body slides", "no shape tells the slide", "stays, says so, still goes up and down",
       smooth_body_that_slides},
      {"object: its skin is hidden", "a hand lies over it while the body rises", "stays, says so, comes back",
       hidden_from_the_camera},
      {"object pressed as the body rises", "its place comes 30 times a second", "at most 0.1 N a tick",
       felt_under_a_skin_that_moves},
  };
}

}  // namespace telepalp::hard_cases
