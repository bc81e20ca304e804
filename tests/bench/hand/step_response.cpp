#include <algorithm>
#include <cmath>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// The patient rises or sinks by 10 mm from one instant to the next, under a hand that does not move. How long until
// the force is within a tenth of it for good, and how smoothly does it come?

namespace telepalp::bench::hand {
namespace {

constexpr double kStep_m = 0.01;
constexpr double kStepAt_s = 3.01;  // between two frames
constexpr double kWaits_s = 12.0;

struct Outcome {
  double waited_s = 0.0;
  double force_step_N = 0.0;
};

Outcome play(double frame_hz, bool rises, effects::SkinAnchor anchor, const Spot& spot, std::uint64_t seed) {
  const auto patient = torso();
  const double sign = rises ? 1.0 : -1.0;
  Feed feed({.patient = patient,
             .pose =
                 [&](double t) {
                   server::PatientPose pose;
                   pose.rise_m = t >= kStepAt_s ? sign * kStep_m : 0.0;
                   return pose;
                 },
             .link = {.one_way_s = 0.0, .jitter_s = 0.0, .loss = 0.0, .seed = seed},
             .builder = {},
             .frame_hz = frame_hz});
  const double depth_m = rises ? 0.005 : 0.015;
  BenchStation station(with_skin(anchor), haptic_from_camera(*patient, spot),
                       std::make_unique<RigidHand>([&](double t, const control::ControlOutput&) {
                         return Point<HapticBase>{{0.0, 0.04 - (0.04 + depth_m) * eased(t - 0.9), 0.0}};
                       }));
  const double first_seen_s = std::ceil(kStepAt_s * frame_hz) / frame_hz;
  Outcome outcome;
  ForceSteps steps;
  double law_before_N = 0.0;
  run(feed, station, kStepAt_s + kWaits_s, [&](const Tick& tick) {
    steps.add(tick);
    if (tick.time_s < kStepAt_s) {
      law_before_N = tick.law_N();
    } else if (std::abs(tick.pushed_N() - tick.law_N()) > 0.1 * std::abs(tick.law_N() - law_before_N)) {
      outcome.waited_s = tick.time_s - first_seen_s;  // an overshoot has not arrived
    }
  });
  outcome.force_step_N = steps.worst_N();
  return outcome;
}

std::vector<Row> measure(const std::string& name, double frame_hz, const Options& options) {
  struct Cell {
    bool rises;
    effects::SkinAnchor anchor;
    Spot spot;
  };
  std::vector<Cell> cells;
  for (const bool rises : {true, false})
    for (const auto anchor : {effects::SkinAnchor::FollowsSurface, effects::SkinAnchor::Sliding})
      for (const Spot& spot : spots().first(2)) cells.push_back({rises, anchor, spot});
  std::vector<Outcome> all(cells.size());
  for_each_parallel(static_cast<int>(cells.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play(frame_hz, cells[at].rises, cells[at].anchor, cells[at].spot, at + 1);
  });
  Outcome worst{.waited_s = 0.0};
  for (const Outcome& one : all) {
    worst.waited_s = std::max(worst.waited_s, one.waited_s);
    worst.force_step_N = std::max(worst.force_step_N, one.force_step_N);
  }
  return {at_most(name + ": until within a tenth of 10 mm for good, worst", worst.waited_s, "s", 0.6),
          at_most(name + ": force step a tick, worst", worst.force_step_N, "N", 0.1)};
}

}  // namespace

std::vector<Study> step_response() {
  std::vector<Study> studies;
  for (const int hz : {10, 30, 60, 100, 200}) {
    const std::string name = "step/" + std::to_string(hz) + " Hz";
    studies.push_back({name, [name, hz](const Options& options) { return measure(name, hz, options); }});
  }
  return studies;
}

}  // namespace telepalp::bench::hand
