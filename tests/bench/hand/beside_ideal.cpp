#include <cmath>

#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/studies.h"

// A hand is held in the skin of a patient who moves. An ideal display of the newest image would give the law's force on
// the true skin at that image's capture, without an anchor and without a delay of its own. This study divides the
// station's force error by that of the ideal display. Both errors are against the law on the true skin of the instant.

namespace telepalp::bench::hand {
namespace {

constexpr int kIdealEvery = 4;  // judges each fourth tick

/// Sums of squared errors of the station and the ideal display.
struct SquaredErrors {
  double station_N2 = 0.0;
  double ideal_N2 = 0.0;
  double contact_s = 0.0;
};

void judge(const Feed& feed, const Tick& tick, const Transform<HapticBase, DepthCamera>& placed, SquaredErrors& one) {
  const double station_N = tick.pushed_N() - tick.law_N();
  const double shown_N = newest_image_N(feed, tick, placed).dot(tick.normal) - tick.law_N();
  one.station_N2 += station_N * station_N;
  one.ideal_N2 += shown_N * shown_N;
  one.contact_s += tick.displayed ? kIdealEvery * kTick_s : 0.0;
}

/// The station's RMS error divided by the ideal's, for each delay; the larger one of both anchors. NaN without contact.
OfDelays play_beside_ideal(const Pattern& pattern, const Spot& spot) {
  const auto patient = torso();
  const PoseScript pose = script(pattern, patient, spot);
  Feed feed({.patient = patient, .pose = pose, .link = link_before_delays(), .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const auto path = [&](double t, const control::ControlOutput&) {
    const double height_m = reaching_m(t, kDepth_m) + ridden_m(pattern, pose, *patient, placed, t);
    return Point<HapticBase>{{0.0, height_m, 0.0}};
  };
  std::vector<DelayedStation> stations = stations_at_delays(placed, [&] { return std::make_unique<RigidHand>(path); });
  std::vector<SquaredErrors> all(stations.size());
  run_together(feed, stations, kUntil_s, [&](std::size_t index, const Tick& tick) {
    const std::int64_t number = std::llround(tick.time_s / kTick_s);
    if (tick.time_s >= kFrom_s && number % kIdealEvery == 0) judge(feed, tick, placed, all[index]);
  });
  OfDelays ratios{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool touched = all[i].contact_s > 0.5 * (kUntil_s - kFrom_s);
    const double ratio = touched ? std::sqrt(all[i].station_N2 / all[i].ideal_N2) : NAN;
    double& worst = ratios[stations[i].delay];
    worst = i < kDelays_s.size() || !(ratio <= worst) ? ratio : worst;
  }
  return ratios;
}

/// For each pattern and delay, the worst spot's ratio.
std::vector<OfDelays> worst_ratios(std::span<const Pattern> patterns, const Options& options) {
  const std::size_t spot_count = spots().size();
  std::vector<OfDelays> all(patterns.size() * spot_count);
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play_beside_ideal(patterns[at / spot_count], spots()[at % spot_count]);
  });
  std::vector<OfDelays> worst(patterns.size());
  for (std::size_t at = 0; at < all.size(); ++at)
    for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
      double& so_far = worst[at / spot_count][delay];
      if (!(all[at][delay] <= so_far)) so_far = all[at][delay];
    }
  return worst;
}

std::vector<Row> measure_beside_ideal(std::span<const Pattern> patterns, const OfDelays& reach,
                                      const Options& options) {
  const std::vector<OfDelays> worst = worst_ratios(patterns, options);
  std::vector<Row> rows;
  for (std::size_t at = 0; at < patterns.size(); ++at)
    for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay)
      rows.push_back(at_most("ideal/" + std::string(patterns[at].name) + ": force RMSE at a delay of " +
                                 delay_name(delay) + ", divided by that of an ideal display of the newest image, worst",
                             worst[at][delay], "", reach[delay]));
  return rows;
}

std::vector<Row> measure_breaths(const Options& options) {
  std::vector<Row> rows = measure_beside_ideal(breaths(), {0.6, 0.6, 0.6}, options);
  double logs = 0.0;
  for (const Row& row : rows) logs += std::log(row.value);
  const double mean = std::exp(logs / static_cast<double>(rows.size()));
  rows.push_back(at_most("ideal/breaths: geometric mean of these ratios", mean, "", 0.3));
  return rows;
}

}  // namespace

std::vector<Study> beside_ideal() {
  return {{"ideal/breaths", measure_breaths},
          {"ideal/sit-up",
           [](const Options& options) {
             return measure_beside_ideal({&sit_up(), 1}, {0.5, 0.5, 0.5}, options);
           }},
          {"ideal/talk",
           [](const Options& options) {
             return measure_beside_ideal({&talk(), 1}, {1.05, 1.0, 0.9}, options);
           }},
          {"ideal/jolts", [](const Options& options) {
             return measure_beside_ideal(jolts(), {1.25, 1.15, 1.1}, options);
           }}};
}

}  // namespace telepalp::bench::hand
