#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand keeps pressing while the camera loses the patient, or the patient moves. Measures the time from the end of the
// event until the hand feels the true skin again. Frames are lost in bursts, so in some runs they are missing again, or
// still, after the event: the newest image becomes too old, and the watchdog releases the hand. Rows of their own count
// the time anew from the last return of the frames. Whether frames are missing is seen at the link, not at the station.

namespace telepalp::bench::hand {
namespace {

constexpr double kEvent_s = 3.0;        // time of the event; the hand presses by then
constexpr double kJudgedAfter_s = 3.0;  // time after which the force is compared with the law's
constexpr double kAveraged_s = 0.5;     // interval over which the force is compared with the law's
constexpr double kAimDepth_m = 0.024;   // aim of a soft arm; the hand is 7 mm deep, and 15 mm after a shift of 30 mm
constexpr double kSoftArm_N_per_m = 200.0;
constexpr double kLongest_s = 60.0;  // a run whose frames are still missing at this time misses its budget

enum class Event { Gap, Shift, Hole, Black, ForeignHand };

/// When the skin is to be felt again, and how far the force may then differ from the law's.
struct Reach {
  double felt_s;
  double off_share;  ///< kJudgedAfter_s later
};
constexpr Reach kFromEvent{.felt_s = 1.5, .off_share = 0.05};  // frames may still be missing

/// From the frames' return.
constexpr Reach reach_of(Event event) noexcept {
  switch (event) {
    case Event::Gap:
    case Event::Shift:
      return {.felt_s = 1.2, .off_share = 0.02};
    case Event::Hole:
    case Event::Black:
      return {.felt_s = 0.75, .off_share = 0.02};
    case Event::ForeignHand:
      break;
  }
  return {.felt_s = 1.5, .off_share = 0.02};
}

struct GapCase {
  Event event = Event::Gap;
  std::uint64_t seed = 1;
  double lasts_s = 0.0;
  double rises_m = 0.0;  ///< rise of the patient during the event
  double one_way_s = 0.0;
  Spot spot = {};
  effects::SkinAnchor anchor = effects::SkinAnchor::FollowsSurface;
};

GapCase draw(Event event, int number) {
  device::Random random(1000 + static_cast<std::uint64_t>(number));
  GapCase drawn{.event = event, .seed = static_cast<std::uint64_t>(number) + 1};
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
bool damage(const GapCase& drawn, const Intrinsics& camera, DepthImage& depth) {
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

/// A stretch of time that begins when the hand could feel the skin again: after the event, or after a later return of
/// the frames.
struct Stretch {
  double from_s = 0.0;
  double waited_s = 0.0;  ///< time until the force reached 90 % of the law's; the whole time if it never does
  bool felt = false;
  double force_sum_N = 0.0;  ///< sum of the displayed force over the ticks after kJudgedAfter_s [N]
  double law_sum_N = 0.0;    ///< sum of the law's force over the same ticks [N]

  /// Adds the next tick. False: the stretch is long enough, and has all its figures.
  bool add(const Tick& tick) noexcept {
    const double since_s = tick.time_s - from_s;
    if (!felt) waited_s = since_s;
    felt = felt || (tick.law_N() > 0.0 && tick.pushed_N() >= 0.9 * tick.law_N());
    if (since_s >= kJudgedAfter_s && since_s < kJudgedAfter_s + kAveraged_s) {
      force_sum_N += tick.pushed_N();
      law_sum_N += tick.law_N();
    }
    return since_s < kJudgedAfter_s + kAveraged_s;
  }
  /// Deviation from the law, kJudgedAfter_s after the beginning.
  [[nodiscard]] double off_share() const noexcept {
    return law_sum_N > 0.0 ? std::abs(force_sum_N - law_sum_N) / law_sum_N : 1.0;
  }
};

struct Waits {
  double waited_s = 0.0;   ///< time until 90 % of the law's force
  double off_share = 1.0;  ///< deviation from the law, kJudgedAfter_s later

  [[nodiscard]] bool holds(const Reach& reach) const noexcept {
    return waited_s <= reach.felt_s && off_share <= reach.off_share;
  }
  void take_worse(const Waits& other) noexcept {
    waited_s = std::max(waited_s, other.waited_s);
    off_share = std::max(off_share, other.off_share);
  }
};

struct FeltAgain {
  Waits from_event;             ///< counted from the first frame after the event
  Waits from_return;            ///< counted from each return of the frames: the longest time, and the last deviation
  double waited_again_s = 0.0;  ///< longest time, without the return after the event
  double step_N = 0.0;
  bool missing_again = false;         ///< frames were missing again, or still, after the event
  bool released_with_frames = false;  ///< the station released the hand, although the link gave it frames

  void add(const Stretch& stretch) noexcept {
    from_return.waited_s = std::max(from_return.waited_s, stretch.waited_s);
    from_return.off_share = stretch.off_share();
    if (missing_again) waited_again_s = std::max(waited_again_s, stretch.waited_s);
  }
};

FeltAgain play_felt_again(const GapCase& drawn) {
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
                       std::make_unique<ArmHand>(kSoftArm_N_per_m, [normal](double t) {
                         // Along the normal, so that the hand does not slide off an oblique skin.
                         const double height_m = 0.04 - (0.04 + kAimDepth_m) * eased((t - 0.9) / 1.1);
                         return device::Intention{{height_m * normal}, {}};
                       }));
  const double back_s = kEvent_s + drawn.lasts_s + drawn.one_way_s + 2.0 / 30.0;
  const double limit_s = settings.control.ages.surface_s;
  FeltAgain outcome;
  ForceSteps steps;
  Stretch from_event{.from_s = back_s};
  Stretch stretch = from_event;
  double seen_s = 0.0;  // capture time of the newest received image that shows the patient [s]
  run_while(feed, station, [&](const Tick& tick) {
    steps.add(tick);
    if (!during(feed.newest_captured_s())) seen_s = feed.newest_captured_s();
    constexpr double kRounding_s = 1e-6;
    const bool link_gap = tick.time_s - seen_s > limit_s - kRounding_s && tick.surface_age_s > limit_s;
    const bool released = tick.control.phase == control::Phase::Released;
    const bool releases = released && tick.control.previous != control::Phase::Released;
    if (tick.time_s >= kEvent_s && releases && !link_gap) outcome.released_with_frames = true;
    if (tick.time_s < back_s) return true;
    const bool goes_on = from_event.add(tick);
    if (!released || !link_gap) return stretch.add(tick) || goes_on;
    outcome.add(stretch);
    outcome.missing_again = true;
    stretch = {.from_s = tick.time_s + kTick_s};
    return tick.time_s < kLongest_s;
  });
  outcome.add(stretch);
  outcome.from_event = {from_event.waited_s, from_event.off_share()};
  outcome.step_N = steps.worst_N();
  return outcome;
}

/// The rows for the times of `all` that `waits` selects. `from`: the beginning of these times, for the rows' names.
std::vector<Row> waits_rows(const std::string& name, const std::string& from, const std::vector<FeltAgain>& all,
                            Waits FeltAgain::*waits, const Reach& reach) {
  Waits worst{.off_share = 0.0};
  int felt = 0;
  for (const FeltAgain& one : all) {
    worst.take_worse(one.*waits);
    felt += (one.*waits).holds(reach) ? 1 : 0;
  }
  char within[64];
  std::snprintf(within, sizeof within, "%g s and within %g %%", reach.felt_s, 100.0 * reach.off_share);
  return {at_least(name + ": skin felt again within " + within + " of the force law" + from + ", share of runs",
                   100.0 * felt / static_cast<double>(all.size()), "%", 100.0),
          at_most(name + ": time until the force is 90 % of the force law's" + from + ", worst", worst.waited_s, "s",
                  reach.felt_s),
          at_most(name + ": force error after 3 s" + from + ", share of the force law's force, worst",
                  100.0 * worst.off_share, "%", 100.0 * reach.off_share)};
}

std::vector<Row> measure_felt_again(const std::string& name, Event event, const Options& options) {
  std::vector<FeltAgain> all(static_cast<std::size_t>(options.seeds));
  for_each_parallel(options.seeds, options,
                    [&](int i) { all[static_cast<std::size_t>(i)] = play_felt_again(draw(event, i)); });
  std::vector<Row> rows = waits_rows(name, "", all, &FeltAgain::from_event, kFromEvent);
  const std::vector<Row> returns =
      waits_rows(name, ", from the last return of the frames", all, &FeltAgain::from_return, reach_of(event));
  rows.insert(rows.end(), returns.begin(), returns.end());
  const auto share = [&](auto&& is) {
    return 100.0 * static_cast<double>(std::count_if(all.begin(), all.end(), is)) / options.seeds;
  };
  const auto worst = [&](double FeltAgain::*value) {
    double most = 0.0;
    for (const FeltAgain& one : all) most = std::max(most, one.*value);
    return most;
  };
  const std::string again = name + ", frames missing a second time: ";
  rows.push_back(at_most(name + ": force step in one tick, worst", worst(&FeltAgain::step_N), "N", 0.1));
  rows.push_back(at_most(name + ": all force ended while frames arrive, share of runs",
                         share([](const FeltAgain& one) { return one.released_with_frames; }), "%", 0.0));
  rows.push_back(measured(again + "share of runs", share([](const FeltAgain& one) { return one.missing_again; }), "%"));
  rows.push_back(at_most(again + "time until the force is 90 % of the force law's, worst",
                         worst(&FeltAgain::waited_again_s), "s", reach_of(event).felt_s));
  return rows;
}

}  // namespace

std::vector<Study> skin_felt_again() {
  std::vector<Study> studies;
  for (const auto& [name, event] : {std::pair{"again/gap", Event::Gap}, std::pair{"again/shift", Event::Shift},
                                    std::pair{"again/hole", Event::Hole}, std::pair{"again/black", Event::Black},
                                    std::pair{"again/foreign hand", Event::ForeignHand}})
    studies.push_back(
        {name, [name, event](const Options& options) { return measure_felt_again(name, event, options); }});
  return studies;
}

}  // namespace telepalp::bench::hand
