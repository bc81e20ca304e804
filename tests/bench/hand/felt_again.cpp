#include <algorithm>
#include <cmath>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand keeps pressing while the camera loses the patient, or the patient moves. Measures the time until it feels the
// true skin again. Frames are lost in bursts, so in some runs they are missing again, or still, after the event: the
// newest image becomes too old, and the watchdog releases the hand. The times then count anew from the return of the
// frames, and rows of their own state these runs. Whether frames are missing is seen at the link, not at the station.

namespace telepalp::bench::hand {
namespace {

constexpr double kEvent_s = 3.0;       // time of the event; the hand presses by then
constexpr double kJudged_s = 3.0;      // measured time after the last return of the frames
constexpr double kAveraged_s = 0.5;    // interval over which the force is compared with the law's
constexpr double kAimDepth_m = 0.024;  // aim of a soft arm; the hand is 7 mm deep, and 15 mm after a shift of 30 mm
constexpr double kArm_N_per_m = 200.0;
constexpr double kLongest_s = 60.0;  // a run in which frames are still missing then does not hold

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

/// Time without a gap of frames that makes the watchdog release the hand.
struct Stretch {
  double from_s = 0.0;
  double waited_s = 0.0;  ///< time until the force reached 90 % of the law's; the whole time if it never does
  bool felt = false;
  double force_Ns = 0.0;  ///< after kJudged_s
  double law_Ns = 0.0;    ///< after kJudged_s

  /// False: the stretch has been measured.
  bool add(const Tick& tick) noexcept {
    const double since_s = tick.time_s - from_s;
    if (!felt) waited_s = since_s;
    felt = felt || (tick.law_N() > 0.0 && tick.pushed_N() >= 0.9 * tick.law_N());
    if (since_s >= kJudged_s) {
      force_Ns += tick.pushed_N();
      law_Ns += tick.law_N();
    }
    return since_s < kJudged_s + kAveraged_s;
  }
};

struct Outcome {
  double waited_s = 0.0;        ///< longest time from a return of the frames until 90 % of the law's force
  double waited_again_s = 0.0;  ///< the same, without the return after the event
  double off_share = 1.0;       ///< deviation from the law, kJudged_s after the last return of the frames
  double step_N = 0.0;
  bool missing_again = false;         ///< frames were missing again, or still, after the event
  bool released_with_frames = false;  ///< the station released the hand, although the link gave it frames

  void add(const Stretch& stretch) noexcept {
    waited_s = std::max(waited_s, stretch.waited_s);
    if (missing_again) waited_again_s = std::max(waited_again_s, stretch.waited_s);
  }
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
  const StationSettings settings = with_skin(drawn.anchor);
  BenchStation station(settings, haptic_from_camera(*patient, drawn.spot),
                       std::make_unique<ArmHand>(kArm_N_per_m, [normal](double t) {
                         // Along the normal, so that the hand does not slide off an oblique skin.
                         const double height_m = 0.04 - (0.04 + kAimDepth_m) * eased((t - 0.9) / 1.1);
                         return device::Intention{{height_m * normal}, {}};
                       }));
  const double back_s = kEvent_s + drawn.lasts_s + drawn.one_way_s + 2.0 / 30.0;
  const double limit_s = settings.control.ages.surface_s;
  Outcome outcome;
  ForceSteps steps;
  Stretch stretch{.from_s = back_s};
  double seen_s = 0.0;  // capture of the newest image that shows the patient
  run_while(feed, station, [&](const Tick& tick) {
    steps.add(tick);
    if (!during(feed.newest_captured_s())) seen_s = feed.newest_captured_s();
    constexpr double kRounding_s = 1e-6;
    const bool link_gap = tick.time_s - seen_s > limit_s - kRounding_s && tick.surface_age_s > limit_s;
    const bool released = tick.control.phase == control::Phase::Released;
    const bool releases = released && tick.control.previous != control::Phase::Released;
    if (tick.time_s >= kEvent_s && releases && !link_gap) outcome.released_with_frames = true;
    if (tick.time_s < back_s) return true;
    if (!released || !link_gap) return stretch.add(tick);
    outcome.add(stretch);
    outcome.missing_again = true;
    stretch = {.from_s = tick.time_s + kTick_s};
    return tick.time_s < kLongest_s;
  });
  outcome.add(stretch);
  outcome.step_N = steps.worst_N();
  if (stretch.law_Ns > 0.0) outcome.off_share = std::abs(stretch.force_Ns - stretch.law_Ns) / stretch.law_Ns;
  return outcome;
}

std::vector<Row> measure(const std::string& name, Event event, const Options& options) {
  std::vector<Outcome> all(static_cast<std::size_t>(options.seeds));
  for_each_parallel(options.seeds, options, [&](int i) { all[static_cast<std::size_t>(i)] = play(draw(event, i)); });
  Outcome worst{.off_share = 0.0};
  int felt = 0;
  int missing_again = 0;
  int released_with_frames = 0;
  for (const Outcome& one : all) {
    felt += one.waited_s <= 1.5 && one.off_share <= 0.05 ? 1 : 0;
    missing_again += one.missing_again ? 1 : 0;
    released_with_frames += one.released_with_frames ? 1 : 0;
    worst.waited_s = std::max(worst.waited_s, one.waited_s);
    worst.waited_again_s = std::max(worst.waited_again_s, one.waited_again_s);
    worst.off_share = std::max(worst.off_share, one.off_share);
    worst.step_N = std::max(worst.step_N, one.step_N);
  }
  const auto share = [&](int runs) { return 100.0 * runs / options.seeds; };
  const std::string again = name + ", frames missing again: ";
  return {at_least(name + ": felt again, share of seeds", share(felt), "%", 100.0),
          at_most(name + ": until nine tenths of the law, worst", worst.waited_s, "s", 1.5),
          at_most(name + ": off the law after 3 s, worst", 100.0 * worst.off_share, "%", 5.0),
          at_most(name + ": force step a tick, worst", worst.step_N, "N", 0.1),
          at_most(name + ": released while frames arrive, share of seeds", share(released_with_frames), "%", 0.0),
          measured(again + "share of seeds", share(missing_again), "%"),
          at_most(again + "until nine tenths of the law, worst", worst.waited_again_s, "s", 1.5)};
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
