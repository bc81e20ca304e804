#include <algorithm>
#include <limits>
#include <string>

#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// The hand leaves the skin, and comes back fast just when the end-effector moves to the plane. Measures for how long
// and how deep the hand is in the true skin without half of the law's force. Frames are lost in bursts, so in some runs
// the surface becomes too old, and the watchdog releases the hand. The time after that has rows of its own.

namespace telepalp::bench::hand {
namespace {

constexpr double kDeepest_m = 0.02;

/// Time and depth in the true skin without the skin's force.
struct Unfelt {
  double longest_s = 0.0;
  double deepest_m = 0.0;

  void add(const Tick& tick) noexcept {
    longest_s += kTick_s;
    deepest_m = std::max(deepest_m, tick.true_depth_m);
  }
  void take_worse(const Unfelt& other) noexcept {
    longest_s = std::max(longest_s, other.longest_s);
    deepest_m = std::max(deepest_m, other.deepest_m);
  }
};

struct ReEntry {
  bool tried = false;
  bool released = false;  ///< by the watchdog, after the hand had left the skin
  Unfelt before;          ///< until the watchdog released the hand
  Unfelt after;           ///< since then
};

ReEntry play_re_entry(int number) {
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
  ReEntry outcome;
  run(feed, station, 6.0, [&](const Tick& tick) {
    if (tick.time_s > out_s && tick.control.phase == control::Phase::Released) outcome.released = true;
    constexpr double kWithinSensorError_N = 0.25;  // the force of half a millimetre, the sensor's error
    if (tick.time_s < out_s + pause_s || tick.law_N() < kWithinSensorError_N) return;
    outcome.tried = true;
    // Forces of position control do not count as the skin's force.
    if (tick.displayed && tick.pushed_N() >= 0.5 * tick.law_N()) return;
    (outcome.released ? outcome.after : outcome.before).add(tick);
  });
  return outcome;
}

std::vector<Row> measure_re_entry(const Options& options) {
  const int runs = std::max(10, options.seeds);
  std::vector<ReEntry> all(static_cast<std::size_t>(runs));
  for_each_parallel(runs, options, [&](int i) { all[static_cast<std::size_t>(i)] = play_re_entry(i); });
  ReEntry worst;
  worst.tried = true;
  int released = 0;
  for (const ReEntry& one : all) {
    released += one.released ? 1 : 0;
    worst.tried = worst.tried && one.tried;
    worst.before.take_worse(one.before);
    worst.after.take_worse(one.after);
  }
  const double unit = worst.tried ? 1e3 : std::numeric_limits<double>::infinity();
  const std::string after = "re-entry, after the watchdog ended all force: ";
  return {at_most("re-entry: time in the true skin with less than half the force law's force, worst",
                  unit * worst.before.longest_s, "ms", 2.0),
          at_most("re-entry: depth in the true skin with less than half the force law's force, worst",
                  unit * worst.before.deepest_m, "mm", 2.0),
          measured(after + "share of the runs", 100.0 * released / runs, "%"),
          measured(after + "time in the true skin with less than half the force law's force, worst",
                   unit * worst.after.longest_s, "ms"),
          measured(after + "depth in the true skin with less than half the force law's force, worst",
                   unit * worst.after.deepest_m, "mm")};
}

}  // namespace

std::vector<Study> re_entry() { return {{"re-entry", measure_re_entry}}; }

}  // namespace telepalp::bench::hand
