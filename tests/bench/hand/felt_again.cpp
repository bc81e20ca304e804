#include <algorithm>
#include <cmath>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand keeps pressing while the camera loses the patient, or the patient moves. Measures the time until it feels the
// true skin again.

namespace telepalp::bench::hand {
namespace {

constexpr double kEvent_s = 3.0;       // time of the event; the hand presses by then
constexpr double kJudged_s = 3.0;      // measured time after the return of the frames
constexpr double kAveraged_s = 0.5;    // interval over which the force is compared with the law's
constexpr double kAimDepth_m = 0.024;  // aim of a soft arm; the hand is 7 mm deep, and 15 mm after a shift of 30 mm
constexpr double kArm_N_per_m = 200.0;

enum class Event { Gap, Shift, Hole, Black, ForeignHand };

struct Case {
  Event event = Event::Gap;
  std::uint64_t seed = 1;
  double lasts_s = 0.0;
  double rises_m = 0.0;  ///< rise of the patient during the event
  double one_way_s = 0.0;
  Spot spot = {};
  effects::SkinAnchor anchor = effects::SkinAnchor::FollowsSurface;
};

Case draw(Event event, int number) {
  device::Random random(1000 + static_cast<std::uint64_t>(number));
  Case drawn{.event = event, .seed = static_cast<std::uint64_t>(number) + 1};
  drawn.lasts_s = event == Event::Gap ? random.uniform(0.5, 5.0) : random.uniform(0.5, 3.0);
  if (event == Event::Shift) drawn.lasts_s = 0.2;
  const bool moves = event == Event::Shift || (event == Event::Gap && random.uniform() < 0.5);
  drawn.rises_m = moves ? random.uniform(0.005, 0.03) : 0.0;
  drawn.one_way_s = random.uniform(0.0, 0.5);
  drawn.spot = spots()[random.bits() % spots().size()];
  drawn.anchor = number % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding;
  return drawn;
}

/// Overwrites the pixels within `radius_m` of `spot` with `sample(depth)`.
template <class Sample>
void overwrite(DepthImage& depth, const Intrinsics& camera, const Spot& spot, double radius_m, Sample&& sample) {
  const double radius_px = radius_m * camera.fx / 0.8;
  for (int v = 0; v < depth.height; ++v)
    for (int u = 0; u < depth.width; ++u) {
      std::uint16_t& one = depth.samples[static_cast<std::size_t>(v * depth.width + u)];
      if (std::hypot(u - camera.cx - spot.u, v - camera.cy - spot.v) < radius_px) one = sample(one);
    }
}

/// Applies the event to a frame; false: the frame is lost.
bool damage(const Case& drawn, const Intrinsics& camera, DepthImage& depth) {
  switch (drawn.event) {
    case Event::Gap:
      return false;
    case Event::Shift:
      return true;
    case Event::Black:
      std::fill(depth.samples.begin(), depth.samples.end(), std::uint16_t{0});
      return true;
    case Event::Hole:
      overwrite(depth, camera, drawn.spot, 0.045, [](std::uint16_t) { return std::uint16_t{0}; });
      return true;
    case Event::ForeignHand:
      overwrite(depth, camera, drawn.spot, 0.05, [&](std::uint16_t one) {
        const double nearer = 0.08 / depth.unit_m;
        return static_cast<std::uint16_t>(std::max(0.0, one - nearer));
      });
      return true;
  }
  return true;
}

struct Outcome {
  double waited_s = kJudged_s + kAveraged_s;  ///< time until the force reached 90 % of the law's
  double off_share = 1.0;                     ///< deviation from the law after kJudged_s, as a share of it
  double step_N = 0.0;
};

Outcome play(const Case& drawn) {
  const auto patient = torso();
  const Eigen::Vector3d normal = normal_at(*patient, drawn.spot).v;
  const auto during = [&](double t) { return t >= kEvent_s && t < kEvent_s + drawn.lasts_s; };
  Feed feed(
      {.patient = patient,
       .pose =
           [&](double t) {
             capture::PatientPose pose;
             pose.rise_m = drawn.rises_m * eased((t - kEvent_s) / 0.2);
             return pose;
           },
       .damage = [&](double t,
                     DepthImage& depth) { return !during(t) || damage(drawn, patient->settings().camera, depth); },
       .link = {.one_way_s = drawn.one_way_s, .seed = drawn.seed},
       .builder = {}});
  BenchStation station(with_skin(drawn.anchor), haptic_from_camera(*patient, drawn.spot),
                       std::make_unique<ArmHand>(kArm_N_per_m, [normal](double t) {
                         // Along the normal, so that the hand does not slide off an oblique skin.
                         const double height_m = 0.04 - (0.04 + kAimDepth_m) * eased((t - 0.9) / 1.1);
                         return device::Intention{{height_m * normal}, {}};
                       }));
  const double back_s = kEvent_s + drawn.lasts_s + drawn.one_way_s + 2.0 / 30.0;
  Outcome outcome;
  ForceSteps steps;
  double force_Ns = 0.0;
  double law_Ns = 0.0;
  bool felt = false;
  run(feed, station, back_s + kJudged_s + kAveraged_s, [&](const Tick& tick) {
    steps.add(tick);
    if (tick.time_s < back_s) return;
    const double since_s = tick.time_s - back_s;
    if (!felt && tick.law_N() > 0.0 && tick.pushed_N() >= 0.9 * tick.law_N()) {
      felt = true;
      outcome.waited_s = since_s;
    }
    if (since_s < kJudged_s) return;
    force_Ns += tick.pushed_N();
    law_Ns += tick.law_N();
  });
  outcome.step_N = steps.worst_N();
  outcome.off_share = law_Ns > 0.0 ? std::abs(force_Ns - law_Ns) / law_Ns : 1.0;
  return outcome;
}

std::vector<Row> measure(const std::string& name, Event event, const Options& options) {
  std::vector<Outcome> all(static_cast<std::size_t>(options.seeds));
  for_each_parallel(options.seeds, options, [&](int i) { all[static_cast<std::size_t>(i)] = play(draw(event, i)); });
  Outcome worst{.waited_s = 0.0, .off_share = 0.0};
  int felt = 0;
  for (const Outcome& one : all) {
    felt += one.waited_s <= 1.5 && one.off_share <= 0.05 ? 1 : 0;
    worst.waited_s = std::max(worst.waited_s, one.waited_s);
    worst.off_share = std::max(worst.off_share, one.off_share);
    worst.step_N = std::max(worst.step_N, one.step_N);
  }
  return {at_least(name + ": felt again, share of seeds", 100.0 * felt / options.seeds, "%", 100.0),
          at_most(name + ": until nine tenths of the law, worst", worst.waited_s, "s", 1.5),
          at_most(name + ": off the law after 3 s, worst", 100.0 * worst.off_share, "%", 5.0),
          at_most(name + ": force step a tick, worst", worst.step_N, "N", 0.1)};
}

}  // namespace

std::vector<Study> skin_felt_again() {
  std::vector<Study> studies;
  for (const auto& [name, event] : {std::pair{"again/gap", Event::Gap}, std::pair{"again/shift", Event::Shift},
                                    std::pair{"again/hole", Event::Hole}, std::pair{"again/black", Event::Black},
                                    std::pair{"again/foreign hand", Event::ForeignHand}})
    studies.push_back({name, [name, event](const Options& options) { return measure(name, event, options); }});
  return studies;
}

}  // namespace telepalp::bench::hand
