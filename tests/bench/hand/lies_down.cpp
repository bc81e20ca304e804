#include <algorithm>
#include <cmath>

#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/studies.h"

// A patient who sat up into the hand lies down again, and the hand stays where it is. Measures for how long the hand
// still feels the skin although the true skin is more than a millimetre away. After that, the station lifts the
// end-effector and moves it to the plane over the skin; these forces belong to no contact and are not counted.

namespace telepalp::bench::hand {
namespace {

constexpr double kLeaves_s = 31.0;     // the patient, who has sat up a second time, begins to lie down
constexpr double kLiesAgain_s = 35.0;  // the patient lies again
constexpr double kFelt_N = 0.3;
constexpr double kFeltAway_m = 0.001;
constexpr OfDelays kReach_s{0.15, 0.3, 0.7};

struct FeltAir {
  double time_s = 0.0;   ///< time in which the hand feels the skin, but is more than kFeltAway_m above it
  bool pressed = false;  ///< the hand felt the skin before the patient lay down
};

/// The longer time of both anchors, by delay; NaN where the hand did not feel the skin before.
OfDelays play_lies_down(const Spot& spot) {
  const auto patient = torso();
  const PoseScript pose = script(sit_up(), patient, spot);
  Feed feed({.patient = patient, .pose = pose, .link = link_before_delays(), .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const auto path = [&](double t, const control::ControlOutput&) {
    const double ridden_m = rest_height_m(*patient, pose(std::min(t, kLeaves_s)), placed);
    return Point<HapticBase>{{0.0, reaching_m(t, kDepth_m) + ridden_m, 0.0}};
  };
  std::vector<DelayedStation> stations = stations_at_delays(placed, [&] { return std::make_unique<RigidHand>(path); });
  std::vector<FeltAir> all(stations.size());
  run_together(feed, stations, kLiesAgain_s, [&](std::size_t index, const Tick& tick) {
    FeltAir& one = all[index];
    const bool felt = tick.displayed && tick.force_N.norm() > kFelt_N;
    if (tick.time_s < kLeaves_s) one.pressed = felt;
    const bool away = !tick.true_known || tick.true_depth_m < -kFeltAway_m;
    if (tick.time_s >= kLeaves_s && felt && away) one.time_s += kTick_s;
  });
  OfDelays longest_s{};
  for (std::size_t index = 0; index < all.size(); ++index) {
    double& longest = longest_s[stations[index].delay];
    longest = all[index].pressed ? std::max(longest, all[index].time_s) : NAN;
  }
  return longest_s;
}

std::vector<Row> measure_lies_down(const Options& options) {
  std::vector<OfDelays> all(spots().size());
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play_lies_down(spots()[at]);
  });
  std::vector<Row> rows;
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
    double worst_s = 0.0;
    for (const OfDelays& spot : all) worst_s = !(spot[delay] <= worst_s) ? spot[delay] : worst_s;
    rows.push_back(at_most(
        "lies down/" + delay_name(delay) +
            ": time with a contact of more than 0.3 N while the hand is more than 1 mm above the true skin, worst",
        worst_s, "s", kReach_s[delay]));
  }
  return rows;
}

}  // namespace

std::vector<Study> lies_down() { return {{"lies down/", measure_lies_down}}; }

}  // namespace telepalp::bench::hand
