#include "tests/bench/hand/percussion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A doctor percusses: the hand taps four times a second and enters the skin at 0.6 m/s. All taps must feel alike, so
// this study divides the largest force of each tap by the largest force that the true skin would give. A second study
// lets a hand come back after a pause, at each height and in each phase, and measures the force that opposes it while
// it is still above the skin.

namespace telepalp::bench::hand {
namespace {

constexpr double kTap_s = 1.0 / kTaps_hz;
constexpr double kEntry_m_per_s = 0.6;
constexpr double kTapDepth_m = 0.01;  // below the skin at full exhale
constexpr double kOmega_rad_per_s = 2.0 * std::numbers::pi * kTaps_hz;
// A sine of this amplitude goes kTapDepth_m deep, and passes the height of the skin at kEntry_m_per_s.
constexpr double kAmplitude_m =
    (kEntry_m_per_s * kEntry_m_per_s / (kOmega_rad_per_s * kOmega_rad_per_s) + kTapDepth_m * kTapDepth_m) /
    (2.0 * kTapDepth_m);
constexpr double kClearOfSkin_m = 0.001;  // closer to the skin, the force may come from an error of the displayed skin
constexpr double kWayIn_m_per_s = 0.01;   // a slower hand is not on its way in
constexpr double kFeltTap_N = 0.5;        // the law's least peak in a tap
constexpr double kFlesh_m = 0.001;        // a fingertip this close to the end-effector touches it
constexpr double kPressedIn_m = 0.01;     // the fingertip yields less; a lower hand has passed beside the end-effector
constexpr double kReach_m = device::SimulatedHandSettings{}.reach_m;  // a hand farther aside misses the end-effector
constexpr double kWrist_N_per_m = 2000.0;

enum class Hand { Firm, Wrist, Arm };
struct Tapper {
  Hand hand;
  const char* name;
};
constexpr Tapper kTappers[] = {
    {Hand::Firm, "a hand that no force moves"}, {Hand::Wrist, "a wrist of 2000 N/m"}, {Hand::Arm, "an arm of 300 N/m"}};

std::unique_ptr<Person> person(Hand hand, const Eigen::Vector3d& normal, std::function<Height(double time_s)> height) {
  if (hand == Hand::Firm)
    return std::make_unique<RigidHand>([normal, height = std::move(height)](double t, const control::ControlOutput&) {
      return Point<HapticBase>{height(t).m * normal};
    });
  const double stiffness_N_per_m = hand == Hand::Wrist ? kWrist_N_per_m : kArm_N_per_m;
  return std::make_unique<ArmHand>(stiffness_N_per_m, [normal, height = std::move(height)](double t) {
    const Height at = height(t);
    return device::Intention{{at.m * normal}, {at.m_per_s * normal}};
  });
}

/// The largest force against a hand that moves in with the end-effector, more than kClearOfSkin_m above the true skin.
class WayIn {
 public:
  void add(const Tick& tick) noexcept {
    const double in_m = std::min(-tick.moved_m.dot(tick.normal), (hand_m_ - tick.hand_m).dot(tick.normal));
    const Eigen::Vector3d gap_m = tick.device_m - tick.hand_m;
    const bool at_height = gap_m.y() > -kFlesh_m && gap_m.y() < kPressedIn_m;
    const bool pressed = at_height && std::hypot(gap_m.x(), gap_m.z()) < kReach_m;
    const bool above = tick.true_known && tick.true_depth_m < -kClearOfSkin_m;
    if (pressed && above && in_m > kWayIn_m_per_s * kTick_s) most_N_ = std::max(most_N_, before_N_.dot(tick.normal));
    before_N_ = tick.force_N;
    hand_m_ = tick.hand_m;
  }
  [[nodiscard]] double most_N() const noexcept { return most_N_; }

 private:
  Eigen::Vector3d before_N_ = Eigen::Vector3d::Zero();  ///< the force over the last movement
  Eigen::Vector3d hand_m_ = Eigen::Vector3d::Zero();    ///< the hand's place at the last tick
  double most_N_ = 0.0;
};

/// Each tap's largest force divided by the law's largest force in it. NaN: the law gives none, because the hand has
/// missed the end-effector. This happens on a flank: the skin throws the free end-effector aside as the hand leaves it.
struct Taps {
  std::vector<double> ratios;
  double against_N = 0.0;  ///< on the way in
};

Taps tap(Feed& feed, BenchStation& station, double from_s, int taps) {
  Taps all;
  WayIn way_in;
  double number = 0.0, given_N = 0.0, law_N = 0.0;
  // A little longer, so that the last tap ends.
  run(feed, station, from_s + (taps + 0.01) * kTap_s, [&](const Tick& tick) {
    way_in.add(tick);
    const double now = std::floor((tick.time_s - from_s) * kTaps_hz);
    if (now > number) {
      all.ratios.push_back(law_N > kFeltTap_N ? given_N / law_N : NAN);
      given_N = law_N = 0.0;
    }
    number = std::max(number, now);
    if (tick.time_s < from_s) return;
    given_N = std::max(given_N, tick.pushed_N());
    law_N = std::max(law_N, tick.law_N());
  });
  all.against_N = way_in.most_N();
  return all;
}

struct Run {
  Spot spot;
  effects::SkinAnchor anchor;
};

/// Each spot, with both anchors by turns.
std::vector<Run> runs() {
  std::vector<Run> all;
  for (const Spot& spot : spots())
    all.push_back({spot, all.size() % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding});
  return all;
}

std::vector<Taps> tap_everywhere(Hand hand, const Feed::Settings& feed_settings, const Pattern* pattern, double from_s,
                                 int taps, const Options& options) {
  const std::vector<Run> each = runs();
  std::vector<Taps> all(each.size());
  for_each_parallel(static_cast<int>(each.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    Feed::Settings settings = feed_settings;
    settings.link.seed = at + 1;
    if (pattern != nullptr) settings.pose = script(*pattern, settings.patient, each[at].spot);
    Feed feed(settings);
    const Eigen::Vector3d normal = normal_at(*settings.patient, each[at].spot).v;
    BenchStation station(with_skin(each[at].anchor), haptic_from_camera(*settings.patient, each[at].spot),
                         person(hand, normal, [from_s](double t) { return tapping(t, from_s); }));
    all[at] = tap(feed, station, from_s, taps);
  });
  return all;
}

/// The ratios of all taps that met the end-effector; one infinite ratio if no tap did.
Distribution joined(const std::vector<Taps>& all) {
  Distribution ratios;
  for (const Taps& one : all)
    for (const double ratio : one.ratios)
      if (std::isfinite(ratio)) ratios.add(ratio);
  if (ratios.count() == 0) ratios.add(INFINITY);
  return ratios;
}

double missed_percent(const std::vector<Taps>& all) {
  std::size_t taps = 0, missed = 0;
  for (const Taps& one : all) {
    taps += one.ratios.size();
    missed += static_cast<std::size_t>(
        std::count_if(one.ratios.begin(), one.ratios.end(), [](double ratio) { return !std::isfinite(ratio); }));
  }
  return 100.0 * static_cast<double>(missed) / static_cast<double>(taps);
}

double most_against_N(const std::vector<Taps>& all) {
  double most_N = 0.0;
  for (const Taps& one : all) most_N = std::max(most_N, one.against_N);
  return most_N;
}

/// The beginning of a row's name.
std::string name_of(const char* study, const Tapper& tapper) {
  return std::string("percussion/") + study + ", " + tapper.name + ": ";
}

/// A hand that no force moves is always at the end-effector, so each of its taps must meet the skin.
Row missed_row(const char* study, const Tapper& tapper, const std::vector<Taps>& all) {
  const std::string name = name_of(study, tapper) + "taps at which the hand misses the end-effector";
  return tapper.hand == Hand::Firm ? at_most(name, missed_percent(all), "%", 0.0)
                                   : measured(name, missed_percent(all), "%");
}

std::vector<Row> measure_still(const Options& options) {
  constexpr double kTapsFrom_s = 3.0;
  constexpr int kTaps = 24;
  const Feed::Settings feed{.patient = torso(),
                            .pose = [](double) { return capture::PatientPose{}; },
                            .link = {.one_way_s = 0.02, .jitter_s = 0.0, .loss = 0.0},
                            .builder = {}};
  std::vector<Row> rows;
  for (const Tapper& tapper : kTappers) {
    const auto all = tap_everywhere(tapper.hand, feed, nullptr, kTapsFrom_s, kTaps, options);
    const Distribution ratios = joined(all);
    const std::string name = name_of("still", tapper) + "largest force of a tap divided by the law's, ";
    rows.push_back(at_least(name + "least", ratios.quantile(0.0), "", 0.97));
    rows.push_back(at_most(name + "greatest", ratios.max(), "", 1.03));
    rows.push_back(at_most(name_of("still", tapper) + "force against the way in, over 1 mm above the skin",
                           most_against_N(all), "N", 0.2));
    rows.push_back(missed_row("still", tapper, all));
  }
  return rows;
}

/// Difference between the medians of the taps with even and with odd numbers [%].
double even_odd_percent(const std::vector<Taps>& all) {
  std::array<Distribution, 2> of;
  for (const Taps& one : all)
    for (std::size_t i = 0; i < one.ratios.size(); ++i)
      if (std::isfinite(one.ratios[i])) of[i % 2].add(one.ratios[i]);
  return 100.0 * std::abs(of[0].p50() / of[1].p50() - 1.0);
}

std::vector<Row> measure_irregular(const Options& options) {
  constexpr int kTaps = 80;
  const Pattern& irregular = pattern("irregular");
  const Feed::Settings feed{
      .patient = torso(), .pose = {}, .link = {.one_way_s = 0.15, .loss = 0.05, .burst_frames = 1.0}, .builder = {}};
  std::vector<Row> rows;
  for (const Tapper& tapper : kTappers) {
    const auto all = tap_everywhere(tapper.hand, feed, &irregular, kFrom_s, kTaps, options);
    const Distribution ratios = joined(all);
    const std::string name =
        name_of("irregular breath, 150 ms", tapper) + "largest force of a tap divided by the law's, ";
    rows.push_back(at_least(name + "median, lower bound", ratios.p50(), "", 0.98));
    rows.push_back(at_most(name + "median, upper bound", ratios.p50(), "", 1.02));
    rows.push_back(at_least(name + "5th percentile", ratios.quantile(0.05), "", 0.92));
    rows.push_back(at_most(name + "95th percentile", ratios.quantile(0.95), "", 1.08));
    rows.push_back(at_most(name + "difference between even and odd taps", even_odd_percent(all), "%", 2.0));
    rows.push_back(measured(
        name_of("irregular breath, 150 ms", tapper) + "force against the way in, over 1 mm above the true skin",
        most_against_N(all), "N"));
    rows.push_back(missed_row("irregular breath, 150 ms", tapper, all));
  }
  return rows;
}

/// A hand that presses, goes up to `top_m` at kEntry_m_per_s, rests, and comes back at kEntry_m_per_s.
struct Visit {
  double top_m;
  double rests_s;

  static constexpr double kPressed_s = 2.5;
  static constexpr double kFaster_m_per_s2 = 15.0;  // as in a tap

  [[nodiscard]] double up_s() const noexcept { return (top_m + kTapDepth_m) / kEntry_m_per_s * 2.0; }
  [[nodiscard]] Height at(double t) const noexcept {
    if (t < kPressed_s) return {reaching_m(t, kTapDepth_m), 0.0};
    const double since_s = t - kPressed_s;
    if (since_s < up_s()) return {-kTapDepth_m + (top_m + kTapDepth_m) * eased(since_s / up_s()), 0.0};
    const double in_s = since_s - up_s() - rests_s;
    if (in_s <= 0.0) return {top_m, 0.0};
    const double speeding_s = std::min(in_s, kEntry_m_per_s / kFaster_m_per_s2);
    const double gone_m = 0.5 * kFaster_m_per_s2 * speeding_s * speeding_s + kEntry_m_per_s * (in_s - speeding_s);
    const double most_m = top_m + kTapDepth_m;
    return {top_m - std::min(gone_m, most_m), gone_m < most_m ? -kFaster_m_per_s2 * speeding_s : 0.0};
  }
  [[nodiscard]] double ends_s() const noexcept { return kPressed_s + up_s() + rests_s + 0.5; }
};

std::vector<Row> measure_return(const Options& options) {
  const int count = std::max(48, options.seeds);
  std::vector<Row> rows;
  for (const Tapper& tapper : kTappers) {
    std::vector<double> against_N(static_cast<std::size_t>(count));
    for_each_parallel(count, options, [&](int i) {
      device::Random random(8100 + static_cast<std::uint64_t>(i));
      const Visit visit{.top_m = random.uniform(0.005, 0.08), .rests_s = random.uniform(0.0, 1.2)};
      const Run run_of = runs()[static_cast<std::size_t>(i) % runs().size()];
      const auto patient = torso();
      Feed feed({.patient = patient,
                 .pose = [](double) { return capture::PatientPose{}; },
                 .link = {.one_way_s = 0.02, .jitter_s = 0.0, .loss = 0.0},
                 .builder = {}});
      const Eigen::Vector3d normal = normal_at(*patient, run_of.spot).v;
      BenchStation station(with_skin(run_of.anchor), haptic_from_camera(*patient, run_of.spot),
                           person(tapper.hand, normal, [visit](double t) { return visit.at(t); }));
      WayIn way_in;
      run(feed, station, visit.ends_s(), [&](const Tick& tick) { way_in.add(tick); });
      against_N[static_cast<std::size_t>(i)] = way_in.most_N();
    });
    rows.push_back(
        at_most(name_of("return after a pause", tapper) + "force against the way in, over 1 mm above the skin",
                *std::max_element(against_N.begin(), against_N.end()), "N", 0.2));
  }
  return rows;
}

}  // namespace

Height tapping(double time_s, double from_s) noexcept {
  const double phase = kOmega_rad_per_s * std::max(0.0, time_s - from_s);
  return {kAmplitude_m - kTapDepth_m + kAmplitude_m * std::cos(phase),
          -kAmplitude_m * kOmega_rad_per_s * std::sin(phase)};
}

std::vector<Study> percussion() {
  return {{"percussion/still", measure_still},
          {"percussion/irregular breath", measure_irregular},
          {"percussion/return after a pause", measure_return}};
}

}  // namespace telepalp::bench::hand
