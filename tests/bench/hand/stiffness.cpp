#include <array>
#include <cmath>
#include <numbers>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/studies.h"

// A hand presses again and again while the patient breathes or talks. Palpation judges how steeply the force rises as
// the hand goes deeper. This study fits a line to the force over the hand's way into the body, press by press, and
// divides its slope by that of the force law on the true skin over the same way. Rows of their own fit the force over
// the depth below the true skin, which the doctor does not see: there even a display of the newest image errs by the
// skin's motion within its delay.

namespace telepalp::bench::hand {
namespace {

constexpr double kPressesUntil_s = 44.0;
constexpr std::int64_t kPressJudgedEvery = 4;  // judges each fourth tick, because judging takes as long as a tick
constexpr double kPressPeriod_s = 1.7;         // period of the presses; not a multiple of a breath's
constexpr double kPressAbove_m = 0.005, kPressDepth_m = 0.008;  // heights over and below the skin at full exhale
constexpr double kBelowPeak_N = 9.9;                            // above this, the device's peak limits the law's force
constexpr std::size_t kFewest = 25;  // least number of judged ticks in the skin for a press that counts

/// The least-squares line of force over depth, or over the hand's way, of the ticks of one press.
class Slope {
 public:
  void add(double depth_m, double force_N) noexcept {
    ++count_;
    depth_ += depth_m;
    force_ += force_N;
    depth_depth_ += depth_m * depth_m;
    depth_force_ += depth_m * force_N;
  }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] double N_per_m() const noexcept {
    const auto n = static_cast<double>(count_);
    return (n * depth_force_ - depth_ * force_) / (n * depth_depth_ - depth_ * depth_);
  }

 private:
  std::size_t count_ = 0;
  double depth_ = 0.0, force_ = 0.0, depth_depth_ = 0.0, depth_force_ = 0.0;
};

/// Relative deviations of the slopes of all presses, by delay.
struct Deviations {
  using OfPresses = std::array<std::vector<double>, kDelays_s.size()>;
  OfPresses over_way;        ///< of the force over the hand's way, from the slope of the law's force over this way
  OfPresses ideal_over_way;  ///< the same for an ideal display of the newest image
  OfPresses over_depth;      ///< of the force over the depth below the true skin, from the law's stiffness
};

double presses_at(double t) noexcept { return std::max(0.0, t - 2.0) / kPressPeriod_s; }

double height_m(double t) noexcept {
  const double pressed = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * presses_at(t));
  return std::max(0.0, 0.06 - 0.03 * t) + kPressAbove_m - (kPressAbove_m + kPressDepth_m) * pressed;
}

/// The present press at one station.
struct Press {
  double number = 0.0;
  Slope law{};         ///< of the force on the true skin over the hand's way
  Slope station{};     ///< of the station's force over the hand's way
  Slope ideal{};       ///< of the ideal display's force over the hand's way
  Slope over_depth{};  ///< of the station's force over the depth below the true skin
};

void end(const Press& press, std::size_t delay, Deviations& all) {
  if (press.law.count() < kFewest) return;
  const auto off = [](const Slope& slope, double law_N_per_m) { return std::abs(slope.N_per_m() / law_N_per_m - 1.0); };
  all.over_way[delay].push_back(off(press.station, press.law.N_per_m()));
  all.ideal_over_way[delay].push_back(off(press.ideal, press.law.N_per_m()));
  all.over_depth[delay].push_back(off(press.over_depth, kSkin_N_per_m));
}

Deviations play_stiffness(const Pattern& pattern, const Spot& spot) {
  const auto patient = torso();
  Feed feed({.patient = patient, .pose = script(pattern, patient, spot), .link = link_before_delays(), .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const auto path = [](double t, const control::ControlOutput&) { return Point<HapticBase>{{0.0, height_m(t), 0.0}}; };
  std::vector<DelayedStation> stations = stations_at_delays(placed, [&] { return std::make_unique<RigidHand>(path); });
  std::vector<Press> now(stations.size());
  Deviations deviations;
  run_together(feed, stations, kPressesUntil_s, [&](std::size_t index, const Tick& tick) {
    if (tick.time_s < kFrom_s || std::llround(tick.time_s / kTick_s) % kPressJudgedEvery != 0) return;
    Press& press = now[index];
    if (const double number = std::floor(presses_at(tick.time_s)); number != press.number) {
      end(press, stations[index].delay, deviations);
      press = {.number = number};
    }
    if (tick.law_N() <= 0.0 || tick.law_N() >= kBelowPeak_N) return;
    const double way_m = -tick.device_m.dot(tick.normal);
    press.law.add(way_m, tick.law_N());
    press.station.add(way_m, tick.pushed_N());
    press.ideal.add(way_m, newest_image_N(feed, tick, placed).dot(tick.normal));
    press.over_depth.add(tick.true_depth_m, tick.pushed_N());
  });
  return deviations;
}

/// The 95th percentile of the deviations at all `spots` [%].
double p95_percent(std::span<const Deviations> spots, Deviations::OfPresses Deviations::*of, std::size_t delay) {
  Distribution joined;
  for (const Deviations& spot : spots)
    for (const double deviation : (spot.*of)[delay]) joined.add(deviation);
  return 100.0 * joined.quantile(0.95);
}

std::vector<Row> measure_stiffness(std::span<const Pattern> patterns, const OfDelays& reach, const Options& options) {
  const std::size_t spot_count = spots().size();
  std::vector<Deviations> all(patterns.size() * spot_count);
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play_stiffness(patterns[at / spot_count], spots()[at % spot_count]);
  });
  std::vector<Row> rows;
  for (std::size_t at = 0; at < patterns.size(); ++at)
    for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
      const auto cells = std::span(all).subspan(at * spot_count, spot_count);
      const std::string name =
          "stiffness/" + std::string(patterns[at].name) + " at " + delay_name(delay) + ": slope of the force over ";
      const std::string off = ", deviation from the law's, p95 of the presses";
      const double percent = p95_percent(cells, &Deviations::over_way, delay);
      rows.push_back(reach[delay] > 0.0 ? at_most(name + "the hand's way" + off, percent, "%", reach[delay])
                                        : measured(name + "the hand's way" + off, percent, "%"));
      rows.push_back(measured(name + "the hand's way" + off + ", ideal display of the newest image",
                              p95_percent(cells, &Deviations::ideal_over_way, delay), "%"));
      rows.push_back(measured(name + "the true depth" + off, p95_percent(cells, &Deviations::over_depth, delay), "%"));
    }
  return rows;
}

}  // namespace

std::vector<Study> stiffness() {
  return {{"stiffness/breaths",
           [](const Options& options) {
             return measure_stiffness(breaths(), {5.0, 5.0, 5.0}, options);
           }},
          {"stiffness/talk", [](const Options& options) {
             return measure_stiffness({&talk(), 1}, {0.0, 15.0, 0.0}, options);
           }}};
}

}  // namespace telepalp::bench::hand
