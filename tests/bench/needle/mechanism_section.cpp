#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "haptic_station/device/random.h"
#include "haptic_station/mechanism/held_linkage.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/mechanism/dual.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::bench {
namespace {

using mechanism::Branch;
using mechanism::FourBar;
using mechanism::HeldLinkage;

FourBar any_bar(device::Random& random) {
  const auto length_m = [&] { return random.uniform(0.05, 0.2); };
  const auto angle_rad = [&] { return random.uniform(-3.0, 3.0); };
  return {.l1_m = length_m(),
          .l2_m = length_m(),
          .l3_m = length_m(),
          .l4_m = length_m(),
          .needle_rad = angle_rad(),
          .needle_m = length_m(),
          .handle_rad = angle_rad(),
          .handle_at_m = random.uniform(0.0, 0.1),
          .handle_m = length_m()};
}

/// Random linkages in random poses away from their dead points: the work of the force on the hand and that of the force
/// on the tip, in the motion that automatic differentiation gives.
void add_virtual_work(std::vector<Row>& rows) {
  device::Random random(11);
  double compared = 0.0;
  double worst = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    const FourBar bar = any_bar(random);
    const double link3_rad = random.uniform(-3.1, 3.1);
    const Branch branch = random.uniform() < 0.5 ? Branch::Open : Branch::Crossed;
    const Eigen::Vector3d tip_N(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0));
    if (!mechanism::checked_at(bar, link3_rad)) continue;
    const HeldLinkage held(bar, {}, link3_rad, branch);
    if (std::abs(held.sine_of_links()) < 0.1 || held.tip_travel() > 4.9) continue;
    const auto dual =
        mechanism::four_bar_pose(bar, mechanism::Dual(link3_rad, 1.0), branch == Branch::Open ? 1.0 : -1.0);
    const Eigen::Vector3d hand_N = held.hand_force({tip_N}).N;
    const double at_tip = tip_N.x() * dual.tip.x.slope + tip_N.y() * dual.tip.y.slope;
    const double at_hand = hand_N.x() * dual.c.x.slope + hand_N.y() * dual.c.y.slope;
    const double scale = tip_N.head<2>().norm() * std::hypot(dual.tip.x.slope, dual.tip.y.slope);
    worst = std::max(worst, std::abs(at_tip - at_hand) / scale);
    ++compared;
  }
  rows.push_back(at_least("mechanism: linkages and poses compared with virtual work", compared, "", 10'000.0));
  rows.push_back(
      at_most("mechanism: force on the hand against virtual work: greatest error over the force of the needle", worst,
              "N/N", 1e-9));
}

/// The place of a hand that holds the handle's end while link 3 has the angle `link3_rad`.
Point<HapticBase> hand_at(const FourBar& bar, double link3_rad) {
  const mechanism::Lever lever = mechanism::lever_of(bar);
  const double angle_rad = link3_rad + lever.from_link3_rad;
  return {{bar.l4_m + lever.length_m * std::cos(angle_rad), lever.length_m * std::sin(angle_rad), 0.0}};
}

struct ThroughDeadPoints {
  double most_N = 0.0;  ///< on the hand, of 1 N on the needle
  double step_N = 0.0;  ///< greatest change in a tick
  double broken = 0.0;  ///< ticks with a force or place that is not finite, or on the other branch
};
/// S4's first linkage; the hand turns link 3 beyond both dead points and back in `ticks`.
ThroughDeadPoints through_dead_points(Branch branch, int ticks) {
  const FourBar bar{.l1_m = 0.08, .l2_m = 0.15, .l3_m = 0.12, .l4_m = 0.13, .needle_rad = -0.31};
  constexpr double kMiddle_rad = 1.5;
  const Force<HapticBase> needle{{1.0, 0.0, 0.0}};
  HeldLinkage held(bar, {}, kMiddle_rad, branch);
  Eigen::Vector3d last_N = held.hand_force(needle).N;
  ThroughDeadPoints out;
  for (int i = 1; i <= ticks; ++i) {
    held.step(hand_at(bar, kMiddle_rad - 1.5 * std::sin(2.0 * std::numbers::pi * i / ticks)), kTick_s);
    const Eigen::Vector3d now_N = held.hand_force(needle).N;
    if (!now_N.allFinite() || !held.tip().m.allFinite() || held.branch() != branch) ++out.broken;
    out.most_N = std::max(out.most_N, now_N.norm());
    out.step_N = std::max(out.step_N, (now_N - last_N).norm());
    last_N = now_N;
  }
  return out;
}

void add_dead_points(std::vector<Row>& rows) {
  for (const Branch branch : {Branch::Open, Branch::Crossed}) {
    const std::string of = std::string("mechanism: through dead points, ") +
                           (branch == Branch::Open ? "open branch: " : "crossed branch: ");
    const ThroughDeadPoints slow = through_dead_points(branch, 80'000);
    const ThroughDeadPoints slower = through_dead_points(branch, 16 * 80'000);
    // Near a dead point the force changes with the square root of the angle: a sixteenth of the speed leaves about a
    // quarter of the change. A jump would leave all of it.
    constexpr double kRounding = 1e-9;
    rows.push_back(at_most(of + "greatest force on the hand, of 1 N on the needle", slow.most_N, "N",
                           mechanism::HoldSettings{}.most_gain + kRounding));
    rows.push_back(at_least(of + "the same, which shows that the hand came to the dead points", slow.most_N, "N", 2.0));
    rows.push_back(at_most(of + "ticks without a finite force, or on the other branch", slow.broken, "", 0.0));
    rows.push_back(
        at_most(of + "greatest change of the force in a tick, at a sixteenth of the speed over that at the whole",
                slower.step_N / slow.step_N, "", 0.5));
  }
}

}  // namespace

std::vector<Row> run_needle_mechanism_section() {
  std::vector<Row> rows;
  add_virtual_work(rows);
  add_dead_points(rows);
  return rows;
}

}  // namespace telepalp::bench
