#include <algorithm>
#include <cmath>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// The patient rises or sinks by 10 mm from one instant to the next, under a hand that does not move. Measures the time
// until the force stays within a tenth of the step, and the smoothness of the response.

namespace telepalp::bench::hand {
namespace {

constexpr double kStep_m = 0.01;
constexpr double kStepAt_s = 3.01;  // between two frames
constexpr double kWaits_s = 3.0;    // shorter than the motors need to heat up

/// The force after the step.
class Response {
 public:
  void add(const Tick& tick) {
    if (tick.time_s < kStepAt_s) {
      law_before_N_ = tick.law_N();
      return;
    }
    after_.push_back({tick.time_s, tick.pushed_N()});
    law_after_N_ = tick.law_N();
  }
  /// The time from which the force stays within a tenth of the step around its final value. A force that ends a quarter
  /// of the step or more away from the law never settles; a smaller offset comes from the sensor and the anchor.
  [[nodiscard]] double settled_s() const {
    const double step_N = std::abs(law_after_N_ - law_before_N_);
    constexpr std::size_t kAveraged = 400;  // ticks: 0.2 s
    double end_N = 0.0;
    for (auto moment = after_.end() - kAveraged; moment != after_.end(); ++moment) end_N += moment->force_N / kAveraged;
    if (std::abs(end_N - law_after_N_) > 0.25 * step_N) return kStepAt_s + kWaits_s;
    double settled_s = kStepAt_s;
    for (const Moment& moment : after_)
      if (std::abs(moment.force_N - end_N) > 0.1 * step_N) settled_s = moment.time_s;
    return settled_s;
  }

 private:
  struct Moment {
    double time_s;
    double force_N;
  };
  std::vector<Moment> after_;
  double law_before_N_ = 0.0;
  double law_after_N_ = 0.0;
};

struct StepOutcome {
  double waited_s = 0.0;
  double force_step_N = 0.0;
};

StepOutcome play_step_response(double frame_hz, bool rises, effects::SkinAnchor anchor, const Spot& spot,
                               std::uint64_t seed) {
  const auto patient = torso();
  const double sign = rises ? 1.0 : -1.0;
  Feed feed({.patient = patient,
             .pose =
                 [&](double t) {
                   capture::PatientPose pose;
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
  StepOutcome outcome;
  ForceSteps steps;
  Response response;
  run(feed, station, kStepAt_s + kWaits_s, [&](const Tick& tick) {
    steps.add(tick);
    response.add(tick);
  });
  outcome.waited_s = response.settled_s() - first_seen_s;
  outcome.force_step_N = steps.worst_N();
  return outcome;
}

std::vector<Row> measure_step_response(const std::string& name, double frame_hz, const Options& options) {
  struct Cell {
    bool rises;
    effects::SkinAnchor anchor;
    Spot spot;
  };
  std::vector<Cell> cells;
  for (const bool rises : {true, false})
    for (const auto anchor : {effects::SkinAnchor::FollowsSurface, effects::SkinAnchor::Sliding})
      for (const Spot& spot : spots().first(2)) cells.push_back({rises, anchor, spot});
  std::vector<StepOutcome> all(cells.size());
  for_each_parallel(static_cast<int>(cells.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play_step_response(frame_hz, cells[at].rises, cells[at].anchor, cells[at].spot, at + 1);
  });
  StepOutcome worst{.waited_s = 0.0};
  for (const StepOutcome& one : all) {
    worst.waited_s = std::max(worst.waited_s, one.waited_s);
    worst.force_step_N = std::max(worst.force_step_N, one.force_step_N);
  }
  return {
      at_most(
          name +
              ": time until the force has settled to within 10 % of its change, after the skin steps by 10 mm, worst",
          worst.waited_s, "s", 0.6),
      at_most(name + ": force step in one tick, worst", worst.force_step_N, "N", 0.1)};
}

}  // namespace

std::vector<Study> step_response() {
  std::vector<Study> studies;
  for (const int hz : {10, 30, 60, 100, 200}) {
    const std::string name = "step/" + std::to_string(hz) + " Hz";
    studies.push_back({name, [name, hz](const Options& options) { return measure_step_response(name, hz, options); }});
  }
  return studies;
}

}  // namespace telepalp::bench::hand
