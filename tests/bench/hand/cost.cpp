#include <time.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// Measures the cost of a tick and of a snapshot, relative to a fixed computation in the same run. The ratio depends on
// the code and hardly on the machine.

namespace telepalp::bench::hand {
namespace {

// Ratios measured before the surface decided on its side by itself; the requirement is at most a tenth more.
constexpr double kTickRatio = 5.7;
constexpr double kSnapshotRatio = 825.0;

/// CPU time of this thread [us]; other programs do not count.
double now_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// A chain of 2000 dependent multiplications and additions.
double fixed_work() {
  volatile double seed = 1.0;
  double x = seed;
  for (int i = 0; i < 2000; ++i) x = x * 0.999999 + 1e-9;
  return x;
}

std::vector<Row> measure_cost(const Options&) {
  const auto patient = torso();
  const auto pose = [&](double t) { return patient->pose(at_time(t)); };
  const auto placed = haptic_from_camera(*patient, spots()[0]);
  surface::SurfaceBuilder builder{surface::SurfaceSettings{}};
  loop::HapticLoop loop({}, control::EncounteredController({}, with_skin(effects::SkinAnchor::FollowsSurface).effects));
  Distribution tick_us;
  Distribution snapshot_us;
  Distribution work_us;
  loop::TouchableSurface shown;
  double sink = 0.0;
  for (int i = 0; i < 40'000; ++i) {
    const double t = i * kTick_s;
    const Point<HapticBase> device{{0.01 * std::sin(3.0 * t), 0.04 - 0.05 * eased((t - 1.0) / 1.0), 0.0}};
    loop::TickIn in{.now = at_time(t), .dt_s = kTick_s, .reading = {.at = device, .velocity = {}}};
    loop::TouchableSurface before;  // the loop refers to it until this tick
    if (i % 67 == 0) {
      const DepthImage depth = patient->depth_of(pose(t), at_time(t));
      const double start = now_us();
      before = std::move(shown);
      shown = {builder.add(depth, patient->settings().camera, at_time(t),
                           surface::Reach{placed.inverse() * device, surface::kReach_m}),
               placed};
      snapshot_us.add(now_us() - start);
      in.surface = &shown;
    }
    if (i % 20 == 0) in.hand = {at_time(t), device};
    const double start = now_us();
    sink += loop.tick(in).force.N.y();
    tick_us.add(now_us() - start);
    const double work = now_us();
    sink += fixed_work();
    work_us.add(now_us() - work);
  }
  const double unit_us = std::isfinite(sink) ? work_us.p50() : NAN;
  return {measured("cost: time of a fixed computation, median", unit_us, "us"),
          at_most("cost: time of a tick, p99.9, divided by that of the fixed computation",
                  tick_us.quantile(0.999) / unit_us, "", 1.1 * kTickRatio),
          at_most("cost: time of a snapshot, median, divided by that of the fixed computation",
                  snapshot_us.p50() / unit_us, "", 1.1 * kSnapshotRatio)};
}

}  // namespace

std::vector<Study> cost() { return {{"cost", measure_cost}}; }

}  // namespace telepalp::bench::hand
