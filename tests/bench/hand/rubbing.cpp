#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/bench/hand/contact_balance.h"
#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/studies.h"

// An arm presses the skin of a patient who moves, and rests or rubs. Skin that is displayed late pumps energy into the
// hand with each breath or syllable, and damping can take it back only from a hand that moves. This study sums the work
// that the display gave beyond the true skin's, over a contact and over each 0.2 s. An ideal display of the newest
// image, pressed by an arm of its own, shows which part comes from the delay alone.

namespace telepalp::bench::hand {
namespace {

constexpr double kRubsUntil_s = 40.0;
constexpr double kRub_m = 0.015;  // amplitude of the rubbing
constexpr std::array kRubs_m_per_s{0.0, 0.018, 0.088};
constexpr OfDelays kMostInContact_mJ{5.0, 5.0, 30.0};
constexpr OfDelays kMostInWindow_mJ{15.0, 20.0, 30.0};

/// The aim of an arm that presses at the origin of H and rubs along the skin at `mean_m_per_s`. `higher_m`: height by
/// which it has followed the patient.
device::Intention rubbing(double t, const Eigen::Vector3d& normal, double mean_m_per_s, double higher_m) noexcept {
  const double aim_m = kDepth_m * (1.0 + kSkin_N_per_m / kArm_N_per_m);
  const double omega = mean_m_per_s * 0.5 * std::numbers::pi / kRub_m;
  const Eigen::Vector3d along = normal.cross(Eigen::Vector3d::UnitZ()).normalized();
  return {{reaching_m(t, aim_m) * normal + higher_m * Eigen::Vector3d::UnitY() + kRub_m * std::sin(omega * t) * along},
          {kRub_m * omega * std::cos(omega * t) * along}};
}

/// An arm at a display that gives the law's force on the newest image's true skin at once.
struct IdealStation {
  std::unique_ptr<Person> person;
  Eigen::Vector3d before_m = person->device().m;
  ContactBalance balance = {};

  void step(const Feed& feed, const Tick& station, const capture::TrueSurface& truth,
            const Transform<HapticBase, DepthCamera>& placed) {
    Tick tick{.time_s = station.time_s, .device_m = person->device().m};
    tick.moved_m = tick.device_m - before_m;
    tick.surface_age_s = station.surface_age_s;
    before_m = tick.device_m;
    touch(truth, placed, tick);
    tick.force_N = newest_image_N(feed, tick, placed);
    balance.add(tick, tick.force_N);
    person->apply({.force = {tick.force_N}, .torque = {}, .contact = {}, .control = {}, .sample = {}}, tick.time_s,
                  kTick_s);
  }
};

/// The most work beyond the law's [mJ], by delay; the larger one of both anchors.
struct Gained {
  OfDelays contact_mJ{}, window_mJ{};
  OfDelays ideal_contact_mJ{}, ideal_window_mJ{};

  void take_worse(const Gained& other) noexcept {
    for (const auto part :
         {&Gained::contact_mJ, &Gained::window_mJ, &Gained::ideal_contact_mJ, &Gained::ideal_window_mJ})
      for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay)
        (this->*part)[delay] = std::max((this->*part)[delay], (other.*part)[delay]);
  }
};

Gained play_rubbing(const Pattern& pattern, double mean_m_per_s, const Spot& spot) {
  const auto patient = torso();
  const PoseScript pose = script(pattern, patient, spot);
  Feed feed({.patient = patient, .pose = pose, .link = link_before_delays(), .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const Eigen::Vector3d normal = normal_at(*patient, spot).v;
  const auto person = [&]() -> std::unique_ptr<Person> {
    return std::make_unique<ArmHand>(kArm_N_per_m, [&, normal, mean_m_per_s](double t) {
      return rubbing(t, normal, mean_m_per_s, ridden_m(pattern, pose, *patient, placed, t));
    });
  };
  std::vector<DelayedStation> stations = stations_at_delays(placed, person);
  std::vector<ContactBalance> balances(stations.size());
  std::vector<IdealStation> ideals;
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) ideals.push_back({.person = person()});
  capture::TrueSurface truth = feed.truth(0.0);
  run_together(feed, stations, kRubsUntil_s, [&](std::size_t index, const Tick& tick) {
    balances[index].add(tick, tick.displayed ? tick.force_N : Eigen::Vector3d::Zero().eval());
    if (index >= ideals.size()) return;
    if (index == 0) truth = feed.truth(tick.time_s);
    ideals[index].step(feed, tick, truth, placed);
  });
  Gained gained;
  for (std::size_t index = 0; index < stations.size(); ++index) {
    const std::size_t delay = stations[index].delay;
    const bool touched = balances[index].touched_s() > 0.5 * kRubsUntil_s;
    gained.contact_mJ[delay] = std::max(gained.contact_mJ[delay], touched ? balances[index].most_mJ() : INFINITY);
    gained.window_mJ[delay] =
        std::max(gained.window_mJ[delay], touched ? balances[index].most_in_window_mJ() : INFINITY);
  }
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
    gained.ideal_contact_mJ[delay] = ideals[delay].balance.most_mJ();
    gained.ideal_window_mJ[delay] = ideals[delay].balance.most_in_window_mJ();
  }
  return gained;
}

/// Rows of all delays. `bounds_contact`: the work in a contact has a budget, as the work in 0.2 s has; false: it is
/// only measured.
std::vector<Row> measure_rubbing(const Pattern& pattern, bool bounds_contact, const Options& options) {
  std::array<Gained, kRubs_m_per_s.size()> all;
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play_rubbing(pattern, kRubs_m_per_s[at], spots()[at % spots().size()]);
  });
  std::vector<Row> rows;
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
    const std::string name = "rubbing/" + std::string(pattern.name) + " at " + delay_name(delay);
    Gained worst;
    for (std::size_t at = 0; at < all.size(); ++at) {
      const std::string row = name + ", " + std::to_string(std::lround(1e3 * kRubs_m_per_s[at])) +
                              " mm/s: work beyond the law in a contact";
      const double most_mJ = all[at].contact_mJ[delay];
      rows.push_back(bounds_contact ? at_most(row, most_mJ, "mJ", kMostInContact_mJ[delay])
                                    : measured(row, most_mJ, "mJ"));
      rows.push_back(measured(row + ", ideal display of the newest image", all[at].ideal_contact_mJ[delay], "mJ"));
      worst.take_worse(all[at]);
    }
    const double ideal_mJ = worst.ideal_window_mJ[delay];
    rows.push_back(at_most(name + ": work beyond the law in any 0.2 s", worst.window_mJ[delay], "mJ",
                           std::max(kMostInWindow_mJ[delay], ideal_mJ)));
    rows.push_back(
        measured(name + ": work beyond the law in any 0.2 s, ideal display of the newest image", ideal_mJ, "mJ"));
  }
  return rows;
}

}  // namespace

std::vector<Study> rubbing() {
  std::vector<Study> studies;
  for (const char* name : {"regular", "irregular", "talk", "sit-up", "cough", "shift of 10 mm in 50 ms"}) {
    const Pattern& moves = pattern(name);
    const bool bounds_contact =
        std::none_of(jolts().begin(), jolts().end(), [&](const Pattern& jolt) { return jolt.name == moves.name; });
    studies.push_back({"rubbing/" + std::string(name), [&moves, bounds_contact](const Options& options) {
                         return measure_rubbing(moves, bounds_contact, options);
                       }});
  }
  return studies;
}

}  // namespace telepalp::bench::hand
