#include <algorithm>

#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// The hand leaves the skin, and comes back fast just when the end-effector moves to the plane. Measures for how long
// and how deep the hand is in the true skin without half of the law's force.

namespace telepalp::bench::hand {
namespace {

constexpr double kDeepest_m = 0.02;

struct Outcome {
  bool tried = false;
  double unfelt_s = 0.0;
  double unfelt_m = 0.0;
};

Outcome play(int number) {
  device::Random random(300 + static_cast<std::uint64_t>(number));
  const double speed_m_per_s = random.uniform(0.1, 0.8);
  const double pause_s = random.uniform(0.0, 0.3);
  const Spot spot = spots()[random.bits() % spots().size()];
  const auto anchor = number % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding;
  const auto patient = torso();
  Feed feed({.patient = patient,
             .pose = [](double) { return capture::PatientPose{}; },
             .link = {.one_way_s = random.uniform(0.0, 0.5), .seed = static_cast<std::uint64_t>(number) + 1},
             .builder = {}});
  double height_m = 0.04;
  double out_s = 1e9;
  const auto path = [&](double t, const control::ControlOutput& last) {
    if (out_s > t && t > 3.0 && last.phase == control::Phase::OutBody) out_s = t;
    if (t > out_s + pause_s)
      height_m = std::max(-kDeepest_m, height_m - speed_m_per_s * kTick_s);
    else if (t < 3.0)
      height_m = 0.04 - 0.05 * eased((t - 1.4) / 0.6);
    else
      height_m = std::min(0.036, height_m + 0.25 * kTick_s);
    return Point<HapticBase>{{0.0, height_m, 0.0}};
  };
  BenchStation station(with_skin(anchor), haptic_from_camera(*patient, spot), std::make_unique<RigidHand>(path));
  Outcome outcome;
  run(feed, station, 6.0, [&](const Tick& tick) {
    constexpr double kWithinSensorError_N = 0.25;  // the force of half a millimetre, the sensor's error
    if (tick.time_s < out_s + pause_s || tick.law_N() < kWithinSensorError_N) return;
    outcome.tried = true;
    // Forces of position control do not count as the skin's force.
    if (tick.displayed && tick.pushed_N() >= 0.5 * tick.law_N()) return;
    outcome.unfelt_s += kTick_s;
    outcome.unfelt_m = std::max(outcome.unfelt_m, tick.true_depth_m);
  });
  return outcome;
}

std::vector<Row> measure(const Options& options) {
  const int runs = std::max(10, options.seeds / 4);
  std::vector<Outcome> all(static_cast<std::size_t>(runs));
  for_each_parallel(runs, options, [&](int i) { all[static_cast<std::size_t>(i)] = play(i); });
  Outcome worst{.tried = true};
  for (const Outcome& one : all) {
    worst.tried = worst.tried && one.tried;
    worst.unfelt_s = std::max(worst.unfelt_s, one.unfelt_s);
    worst.unfelt_m = std::max(worst.unfelt_m, one.unfelt_m);
  }
  const double unit = worst.tried ? 1e3 : std::numeric_limits<double>::infinity();
  return {at_most("re-entry: time in the true skin unfelt, worst", unit * worst.unfelt_s, "ms", 2.0),
          at_most("re-entry: depth in the true skin unfelt, worst", unit * worst.unfelt_m, "mm", 2.0)};
}

}  // namespace

std::vector<Study> re_entry() { return {{"re-entry", measure}}; }

}  // namespace telepalp::bench::hand
