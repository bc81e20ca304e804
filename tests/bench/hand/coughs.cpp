#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/studies.h"

// A hand rests in the skin of a patient who coughs or talks. A display that froze the skin would have a small force
// error at a long delay, and the doctor would feel no cough. So each cough and each syllable is judged by itself. The
// first figure is the rise of the displayed force, divided by the rise of the force on the true skin. The second is the
// time from the arrival of the image of the event's peak until the force has risen.

namespace telepalp::bench::hand {
namespace {

constexpr double kCoughsUntil_s = 44.0;
constexpr double kLeastRise_N = 0.5;
constexpr double kShownShare = 0.6;
constexpr double kMayLag_s = 0.06;

/// A motion with events (coughs or syllables), and the skin's lift [m] in the same motion without them.
struct Eventful {
  std::string name;
  const Pattern* with;
  double (*without_m)(double time_s);
};

struct Rise {
  double begins_s = 0.0;
  double peaks_s = 0.0;  ///< the time at which the event raises the skin most
  double ends_s = 0.0;
};

/// The events of the motion within [kFrom_s, kCoughsUntil_s].
std::vector<Rise> events_of(const Eventful& motion) {
  constexpr double kMoves_m = 1e-5, kStep_s = 0.001, kMargin_s = 1.0;
  std::vector<Rise> events;
  double most_m = 0.0;
  for (double t = kFrom_s; t < kCoughsUntil_s - kMargin_s; t += kStep_s) {
    const double part_m = motion.with->pose(t).breath.lift_m - motion.without_m(t);
    const bool begins = most_m == 0.0 && part_m > kMoves_m;
    if (begins) events.push_back({.begins_s = t});
    if (part_m > std::max(kMoves_m, most_m)) {
      most_m = part_m;
      events.back().peaks_s = t;
    }
    if (most_m == 0.0 || part_m > kMoves_m) continue;
    events.back().ends_s = t;
    most_m = 0.0;
  }
  if (most_m > 0.0) events.pop_back();
  return events;
}

/// How one event was displayed.
struct Shown {
  double share = 0.0;  ///< rise of the displayed force, divided by the rise of the force on the true skin
  double after_s =
      0.0;  ///< time from the arrival of the peak's image until share >= kShownShare; infinite: it stays below
};

/// At each tick of one station: force on the true skin, displayed force, capture time of the touched image.
struct Track {
  std::vector<float> law_N, pushed_N, captured_s;
};

/// `delay_s`: one-way delay of the station's link. nullopt: the event raises the force on the true skin by less than
/// kLeastRise_N.
std::optional<Shown> judge(const Track& track, const Rise& event, double delay_s) {
  const auto tick_at = [](double time_s) { return static_cast<std::size_t>(std::llround(time_s / kTick_s)); };
  const std::size_t begins = tick_at(event.begins_s);
  const double rise_N = *std::max_element(track.law_N.begin() + static_cast<std::ptrdiff_t>(begins),
                                          track.law_N.begin() + static_cast<std::ptrdiff_t>(tick_at(event.ends_s))) -
                        track.law_N[begins];
  if (rise_N < kLeastRise_N) return std::nullopt;
  std::size_t first = begins;  // the tick at which the event's first image has arrived
  while (track.captured_s[first] < event.begins_s) ++first;
  std::size_t image = first;  // the tick at which the image of its peak, or the next image, has arrived
  constexpr double kHalfFrame_s = 0.5 / 30.0;
  while (track.captured_s[image] < event.peaks_s - kHalfFrame_s) ++image;
  Shown shown{.after_s = std::numeric_limits<double>::infinity()};
  const std::size_t last = tick_at(event.ends_s + delay_s + kJitter_s + kMayLag_s);
  for (std::size_t i = first; i < last; ++i) {
    const double share = (track.pushed_N[i] - track.pushed_N[first]) / rise_N;
    if (shown.share < kShownShare && share >= kShownShare)
      shown.after_s = (static_cast<double>(i) - static_cast<double>(image)) * kTick_s;
    shown.share = std::max(shown.share, share);
  }
  return shown;
}

using ShownOfDelays = std::array<std::vector<Shown>, kDelays_s.size()>;

ShownOfDelays play_coughs(const Eventful& motion, const Spot& spot, double loss) {
  const auto patient = torso();
  Feed feed({.patient = patient,
             .pose = script(*motion.with, patient, spot),
             .link = link_before_delays(loss),
             .builder = {}});
  const auto path = [](double t, const control::ControlOutput&) {
    return Point<HapticBase>{{0.0, reaching_m(t, kDepth_m), 0.0}};
  };
  std::vector<DelayedStation> stations =
      stations_at_delays(haptic_from_camera(*patient, spot), [&] { return std::make_unique<RigidHand>(path); });
  std::vector<Track> tracks(stations.size());
  run_together(feed, stations, kCoughsUntil_s, [&](std::size_t index, const Tick& tick) {
    tracks[index].law_N.push_back(static_cast<float>(tick.law_N()));
    tracks[index].pushed_N.push_back(static_cast<float>(tick.pushed_N()));
    tracks[index].captured_s.push_back(static_cast<float>(tick.time_s - tick.surface_age_s));
  });
  ShownOfDelays all;
  const std::vector<Rise> events = events_of(motion);
  for (std::size_t index = 0; index < stations.size(); ++index)
    for (const Rise& event : events) {
      const std::size_t delay = stations[index].delay;
      if (const auto shown = judge(tracks[index], event, kDelays_s[delay])) all[delay].push_back(*shown);
    }
  return all;
}

/// The displayed events at all spots.
ShownOfDelays play_all(const Eventful& motion, double loss, const Options& options) {
  std::vector<ShownOfDelays> of_spots(spots().size());
  for_each_parallel(static_cast<int>(of_spots.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    of_spots[at] = play_coughs(motion, spots()[at], loss);
  });
  ShownOfDelays joined;
  for (const ShownOfDelays& one : of_spots)
    for (std::size_t delay = 0; delay < joined.size(); ++delay)
      joined[delay].insert(joined[delay].end(), one[delay].begin(), one[delay].end());
  return joined;
}

Distribution shares(const std::vector<Shown>& all) {
  Distribution of;
  for (const Shown& one : all) of.add(one.share);
  return of;
}

std::vector<Row> measure_coughs(const Eventful& motion, const Options& options) {
  const ShownOfDelays clean = play_all(motion, 0.0, options);
  const ShownOfDelays lossy = play_all(motion, 0.1, options);
  std::vector<Row> rows;
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
    const std::string name = "coughs/" + motion.name + " at " + delay_name(delay);
    double latest_s = -std::numeric_limits<double>::infinity();
    for (const Shown& one : clean[delay]) latest_s = std::max(latest_s, one.after_s);
    rows.push_back(at_least(name + ": rise of the force divided by that on the true skin, least of all coughs",
                            shares(clean[delay]).quantile(0.0), "", kShownShare));
    rows.push_back(at_most(name + ": time from the arrival of a cough's image until 60 % of its rise, worst",
                           1e3 * latest_s, "ms", 1e3 * kMayLag_s));
    rows.push_back(measured(name + ": number of coughs", static_cast<double>(clean[delay].size()), ""));
    rows.push_back(measured(name + ", 10 % of the frames lost: rise of the force divided by that on the true skin, 5th "
                                   "percentile",
                            shares(lossy[delay]).quantile(0.05), ""));
  }
  return rows;
}

std::vector<Row> measure_talk(const Eventful& motion, const Options& options) {
  const ShownOfDelays clean = play_all(motion, 0.0, options);
  std::vector<Row> rows;
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
    const std::string name = "coughs/talk at " + delay_name(delay) +
                             ": rise of the force in a syllable divided by that "
                             "on the true skin, ";
    const Distribution all = shares(clean[delay]);
    rows.push_back(measured(name + "median", all.p50(), ""));
    rows.push_back(measured(name + "5th percentile", all.quantile(0.05), ""));
  }
  return rows;
}

}  // namespace

std::vector<Study> coughs() {
  static const Eventful kCough{"cough", &jolts()[0], [](double t) { return breaths()[1].pose(t).breath.lift_m; }};
  static const Eventful kShort{"cough of 8 mm in 0.3 s", &jolts()[1],
                               [](double t) { return breaths()[0].pose(t).breath.lift_m; }};
  static const Eventful kTalk{"talk", &talk(), [](double) { return 0.0; }};
  return {{"coughs/cough", [](const Options& options) { return measure_coughs(kCough, options); }},
          {"coughs/cough of 8 mm", [](const Options& options) { return measure_coughs(kShort, options); }},
          {"coughs/talk", [](const Options& options) { return measure_talk(kTalk, options); }}};
}

}  // namespace telepalp::bench::hand
