#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/bench/hand/patient.h"
#include "tests/bench/hand/pointer_session.h"
#include "tests/bench/hand/studies.h"

// A person moves the hand by a pointer on a page, or by a headset, and then holds it still. Motion of the device that
// the patient's breath does not explain is then the device's own.

namespace telepalp::bench::hand {
namespace {

constexpr double kPress_s = 3.0;         // from the start until the pointer presses, or the headset's hand moves
constexpr double kReleases_s = 5.0;      // time from the press until the button is released
constexpr double kJudgedFrom_s = 10.0;   // time from the press until the judging begins
constexpr double kJudgingLasts_s = 6.0;  // duration of the judging
constexpr double kWindow_s = 0.5;        // a mean over this time is taken off, which removes the patient's breath
// Speed and way of the hand that a headset tracks, and its height above H's origin.
constexpr double kGoes_m_per_s = 0.5, kGoes_m = 0.15, kGoesOver_m = 0.12;

/// Places of the pointer in the patient's image of 320x240 pixels.
constexpr std::array<Pixel, 4> kPlaces{{{160, 120}, {170, 40}, {140, 170}, {90, 120}}};
constexpr std::array kOneWays_s{0.0, 0.05, 0.1, 0.2, 0.3};
constexpr double kPathJitter_s = 0.06;

enum class Way {
  Presses,   ///< the button stays down
  Releases,  ///< the button is released, so that the device is free
  Tracked,   ///< a headset's hand moves 15 cm over the patient and stops at once; the device is free
};
constexpr std::array kWays{Way::Presses, Way::Releases, Way::Tracked};

struct BrowserCase {
  Way way;
  double one_way_s;
  Pixel place;
};

struct Steadiness {
  double swing_m = NAN;  ///< RMS distance of the device from its own mean over kWindow_s
  double saturated_s = 0.0;
  double touched_s = 0.0;
};

/// RMS distance of each position from the mean of those within half of kWindow_s of it.
double swing_of(const std::vector<Eigen::Vector3d>& device_m) {
  const auto window = static_cast<std::size_t>(kWindow_s / PointerSession::kTick_s);
  if (device_m.size() <= window) return NAN;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < window; ++i) sum += device_m[i];
  double squares = 0.0;
  for (std::size_t i = window; i < device_m.size(); ++i) {
    squares += (device_m[i - window / 2] - sum / static_cast<double>(window)).squaredNorm();
    sum += device_m[i] - device_m[i - window];
  }
  return std::sqrt(squares / static_cast<double>(device_m.size() - window));
}

/// One tick of the person, `since_s` after the press.
void tick(PointerSession& run, const BrowserCase& one, double since_s) {
  if (one.way == Way::Tracked) {
    const double went_m = std::clamp(kGoes_m_per_s * since_s, 0.0, kGoes_m);
    return run.tick_tracked({{went_m - 0.5 * kGoes_m, kGoesOver_m, 0.0}});
  }
  run.tick(one.place, since_s >= 0.0 && (one.way == Way::Presses || since_s < kReleases_s));
}

Steadiness hold_still(const BrowserCase& one, std::uint64_t seed) {
  const auto made = PointerSession::make(
      {.path = {.image_s = 0.03 + one.one_way_s, .hand_s = one.one_way_s, .jitter_s = kPathJitter_s, .seed = seed},
       .patient = torso()});
  if (!made) return {};
  PointerSession& run = **made;
  Steadiness seen;
  std::vector<Eigen::Vector3d> device_m;
  while (run.time_s() < kPress_s + kJudgedFrom_s + kJudgingLasts_s) {
    const double since_s = run.time_s() - kPress_s;
    tick(run, one, since_s);
    if (run.seen().contact) seen.touched_s += PointerSession::kTick_s;
    if (since_s < kJudgedFrom_s) continue;
    device_m.push_back(run.seen().device_m);
    if (run.seen().saturated) seen.saturated_s += PointerSession::kTick_s;
  }
  seen.swing_m = swing_of(device_m);
  return seen;
}

std::vector<BrowserCase> cases() {
  std::vector<BrowserCase> all;
  for (const Way way : kWays)
    for (const double one_way_s : kOneWays_s) all.push_back({way, one_way_s, kPlaces[all.size() % kPlaces.size()]});
  return all;
}

std::vector<Row> measure_browser_hand(const Options& options) {
  const std::vector<BrowserCase> tried = cases();
  std::vector<Steadiness> all(tried.size());
  for_each_parallel(static_cast<int>(tried.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = hold_still(tried[at], at + 1);
  });
  std::array<double, kWays.size()> swing_m{};
  double saturated_s = 0.0, pressed_s = HUGE_VAL;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double& worst_m = swing_m[static_cast<std::size_t>(tried[i].way)];
    worst_m = std::isnan(all[i].swing_m) ? NAN : std::max(worst_m, all[i].swing_m);
    saturated_s = std::max(saturated_s, all[i].saturated_s);
    if (tried[i].way != Way::Tracked) pressed_s = std::min(pressed_s, all[i].touched_s);
  }
  const std::string name = "browser's hand, still, 0-300 ms one way, from 10 s after the press: ";
  return {
      at_most(name + "device under a pressing pointer, faster than breath, RMS, worst", 1e3 * swing_m[0], "mm", 0.5),
      at_most(name + "free device, the button is up again", 1e3 * swing_m[1], "mm", 0.5),
      at_most(name + "free device under a headset's hand that went 15 cm", 1e3 * swing_m[2], "mm", 0.5),
      at_most(name + "time with a saturated force, worst", saturated_s, "s", 0.0),
      at_least(name + "contact in a run with a press, shortest", pressed_s, "s", 2.0)};
}

}  // namespace

std::vector<Study> browser_hand() { return {{"browser's hand", measure_browser_hand}}; }

}  // namespace telepalp::bench::hand
