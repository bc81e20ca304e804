#include "tests/bench/users/hover_rows.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/hand/pointer_session.h"

namespace telepalp::bench {
namespace {

/// A way of the pointer, and its speed over the patient.
struct Sweep {
  Pixel from;
  Pixel to;
  double m_per_s;
};

/// From the bed over one arm, the trunk and the other arm to the bed, across the shoulders and the hips, and along the
/// body. 656 pixels are a metre on the body.
constexpr Sweep kSweeps[] = {
    {{320, 240}, {320, 60}, 3.0},  {{320, 60}, {320, 420}, 3.0},  {{320, 420}, {320, 60}, 1.0},
    {{320, 60}, {430, 380}, 3.0},  {{430, 380}, {430, 100}, 0.3}, {{430, 100}, {210, 380}, 3.0},
    {{210, 380}, {210, 100}, 2.0}, {{210, 100}, {210, 380}, 0.5}, {{210, 380}, {500, 240}, 3.0},
    {{500, 240}, {160, 240}, 3.0}, {{160, 240}, {330, 110}, 0.1}, {{330, 110}, {330, 370}, 3.0},
};
constexpr double kPixelsPerMetre = 525.0 / 0.8;
constexpr double kLongest_s = 8.0;  // of a flight over the patient, with the waits for a device that rises
constexpr double kArrived_m = 0.02;
constexpr double kMet_m = 0.03;  // a pressing hand moves along the camera's ray, which is oblique at the image's rim

struct Account {
  int entered = 0;
  int arrived = 0;
  int pressed = 0;  ///< presses that met the skin under the pointer
  int faults = 0;
  double deepest_m = -1.0;
  double slowest_s = 0.0;  ///< longest time from the end of the pointer's way to the arrival of the device
};

Pixel at(const Sweep& sweep, double time_s) {
  const double way_px = std::hypot(sweep.to.u - sweep.from.u, sweep.to.v - sweep.from.v);
  const double share = std::min(1.0, time_s * sweep.m_per_s * kPixelsPerMetre / way_px);
  return {sweep.from.u + share * (sweep.to.u - sweep.from.u), sweep.from.v + share * (sweep.to.v - sweep.from.v)};
}

double lasts_s(const Sweep& sweep) {
  return std::hypot(sweep.to.u - sweep.from.u, sweep.to.v - sweep.from.v) / (sweep.m_per_s * kPixelsPerMetre);
}

/// Counts a fault once, and re-arms.
void end_fault(PointerSession& run, Account& account) {
  if (!run.seen().faulted) return;
  ++account.faults;
  run.rearm();
}

void hover(PointerSession& run, const Sweep& sweep, Account& account) {
  const double began_s = run.time_s();
  bool entered = false, arrived = false;
  while (!arrived && run.time_s() - began_s < lasts_s(sweep) + kLongest_s) {
    run.tick(at(sweep, run.time_s() - began_s), false);
    end_fault(run, account);
    entered = entered || run.seen().contact;
    account.deepest_m = std::max(account.deepest_m, run.seen().true_depth_m);
    const double since_s = run.time_s() - began_s - lasts_s(sweep);
    arrived = since_s > 0.3 && run.seen().from_pointer_m < kArrived_m;
    if (arrived) account.slowest_s = std::max(account.slowest_s, since_s);
  }
  account.entered += entered ? 1 : 0;
  account.arrived += arrived ? 1 : 0;
}

/// Presses where the pointer is, and lets go until the device is out of the body.
void press(PointerSession& run, const Pixel& pointer, Account& account) {
  bool met = false;
  for (const double until_s = run.time_s() + 4.0; run.time_s() < until_s && !met;) {
    run.tick(pointer, true);
    end_fault(run, account);
    met = run.seen().contact && run.seen().from_pointer_m < kMet_m;
  }
  account.pressed += met ? 1 : 0;
  for (const double until_s = run.time_s() + 3.0; run.time_s() < until_s;) {
    run.tick(pointer, false);
    if (!run.seen().contact) break;
  }
}

}  // namespace

Result<std::vector<Row>> hover_rows() {
  const Result<std::unique_ptr<PointerSession>> made = PointerSession::make({});
  if (!made) return made.error();
  PointerSession& run = **made;
  for (int tick = 0; tick < 4000; ++tick) run.tick(kSweeps[0].from, false);
  Account account;
  for (const Sweep& sweep : kSweeps) {
    hover(run, sweep, account);
    press(run, sweep.to, account);
  }
  const double all = std::size(kSweeps);
  return std::vector<Row>{
      at_most("hover: sweeps of a pointer without a button, to 3 m/s, that enter the body, of 12", account.entered, "",
              0.0),
      at_most("hover: deepest place of the hovering device below the true skin", std::max(0.0, 1e3 * account.deepest_m),
              "mm", 0.0),
      at_most("hover: faults", account.faults, "", 0.0),
      at_least("hover: sweeps after which the device waits under the pointer, of 12", account.arrived, "", all),
      at_least("hover: presses after them that meet the skin under the pointer, of 12", account.pressed, "", all),
      measured("hover: longest time from the pointer's rest to the device's arrival", account.slowest_s, "s")};
}

}  // namespace telepalp::bench
