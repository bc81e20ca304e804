#include "tests/bench/tick_times.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/loop/simulated_rig.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::bench {
namespace {

/// A level skin 0.8 m under a Kinect-like camera, with 1 mm of noise.
DepthImage noisy_plane() {
  device::Random random(5);
  DepthImage depth{.width = 640, .height = 480, .unit_m = 0.001, .samples = {}};
  for (int i = 0; i < depth.width * depth.height; ++i)
    depth.samples.push_back(static_cast<std::uint16_t>(std::lround(800.0 + random.normal())));
  return depth;
}

}  // namespace

TickTimes measure_ticks(const effects::EffectBank& bank, device::Trial trial, double seconds) {
  const Intrinsics camera{.width = 640, .height = 480, .fx = 525.0, .fy = 525.0, .cx = 319.5, .cy = 239.5};
  const DepthImage depth = noisy_plane();
  surface::SurfaceBuilder builder{surface::SurfaceSettings{}};
  loop::TouchableSurface shown;
  loop::HapticLoop loop({}, control::EncounteredController({}, bank));
  loop::SimulatedRig rig({.device = {}, .hand = {}, .tracker = {}, .rest = {{0.0, 0.05, 0.0}}},
                         device::ScriptedIntention(device::waypoints(trial), {}));
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  haptic_from_camera.iso = Eigen::Translation3d(0.0, 0.8, 0.0) * Eigen::AngleAxisd(1.5707963, Eigen::Vector3d::UnitX());
  TickTimes took;
  const auto ticks = static_cast<std::int64_t>(seconds / kTick_s);
  for (std::int64_t i = 0; i < ticks; ++i) {
    const SessionTime now{from_seconds(static_cast<double>(i) * kTick_s)};
    loop::TickIn in{.now = now, .dt_s = kTick_s, .hand = rig.hand(now)};
    loop::TouchableSurface before_shown;  // the loop refers to it until this tick
    if (i % kTicksPerFrame == 0) {
      before_shown = std::exchange(shown, {builder.add(depth, camera, now, std::nullopt), haptic_from_camera});
      in.surface = &shown;
    }
    in.reading = rig.read();
    const double cpu_before_us = thread_us();
    const auto before = std::chrono::steady_clock::now();
    const auto act = loop.tick(in);
    const double took_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count();
    took.processor.add(thread_us() - cpu_before_us);
    took.all.add(took_us);
    if (control::is_inside(act.control.phase)) took.contact.add(took_us);
    rig.apply({act.force}, act.contact, kTick_s);
  }
  return took;
}

}  // namespace telepalp::bench
