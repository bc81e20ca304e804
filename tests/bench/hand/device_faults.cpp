#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// The devices give wrong data for a moment while a hand presses: one wrong encoder position, or half a second without
// tracker samples.

namespace telepalp::bench::hand {
namespace {

constexpr double kFault_s = 4.0;
constexpr double kAfter_s = 1.5;

/// A false position for one tick, and the velocity that a device with a low-pass at 150 Hz then reports.
class Glitch {
 public:
  explicit Glitch(double height_m) : height_m_(height_m) {}
  void operator()(double time_s, ports::DeviceReading& reading) {
    constexpr double kShare = 0.32;  // share of a new position difference in the reported velocity
    const auto since = std::llround((time_s - kFault_s) / kTick_s);
    velocity_ *= 1.0 - kShare;
    if (since == 0) velocity_ += kShare * height_m_ / kTick_s;
    if (since == 1) velocity_ -= kShare * height_m_ / kTick_s;
    if (since == 0) reading.at.m.y() += height_m_;
    reading.velocity.v.y() += velocity_;
  }

 private:
  double height_m_;
  double velocity_ = 0.0;
};

struct FaultOutcome {
  double step_N = 0.0;
  double excess_J = 0.0;
  double fell_m = 0.0;
  bool touched = false;  ///< true: in contact at the time of the fault
};

/// `eases_m`: amplitude by which the hand presses and eases, so that a lasting drag would do work on it.
FaultOutcome play_device_faults(effects::SkinAnchor anchor, double glitch_m, bool tracker_silent, double eases_m) {
  const auto patient = torso();
  Feed feed({.patient = patient, .pose = [](double) { return capture::PatientPose{}; }, .link = {}, .builder = {}});
  StationSettings settings = with_skin(anchor);
  if (glitch_m != 0.0) settings.spoil = Glitch(glitch_m);
  if (tracker_silent) settings.tracker_silent = [](double t) { return t >= kFault_s && t < kFault_s + 0.5; };
  BenchStation station(settings, haptic_from_camera(*patient, spots()[0]),
                       std::make_unique<ArmHand>(300.0, [=](double t) {
                         const double down_m = 0.04 - 0.065 * eased((t - 1.0) / 1.0);
                         const double swing_m = eases_m * std::sin(2.0 * std::numbers::pi * std::max(0.0, t - 2.0));
                         return device::Intention{{{0.0, down_m + swing_m, 0.0}}, {}};
                       }));
  FaultOutcome outcome;
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  double law_before_N = 0.0;
  double height_m = 0.0;
  run(feed, station, kFault_s + kAfter_s, [&](const Tick& tick) {
    if (tick.time_s < kFault_s - 0.5 * kTick_s) {
      outcome.touched = tick.displayed;
      height_m = tick.device_m.y();
    } else {
      if (tick.time_s < kFault_s + 0.1) outcome.step_N = std::max(outcome.step_N, (tick.force_N - before_N).norm());
      outcome.excess_J += (before_N.dot(tick.normal) - law_before_N) * tick.moved_m.dot(tick.normal);
      outcome.fell_m = std::max(outcome.fell_m, std::abs(tick.device_m.y() - height_m));
    }
    before_N = tick.force_N;
    law_before_N = tick.law_N();
  });
  return outcome;
}

constexpr std::array kAnchors{effects::SkinAnchor::FollowsSurface, effects::SkinAnchor::Sliding};

std::vector<Row> measure_glitch(const Options& options) {
  constexpr double kEases_m = 0.006;
  constexpr std::array kGlitches_m{0.0003, -0.0003, 0.001, -0.001, 0.002, -0.002};
  std::array<FaultOutcome, kAnchors.size() * kGlitches_m.size()> all;
  std::array<double, kAnchors.size()> without_J{};
  for (std::size_t i = 0; i < kAnchors.size(); ++i)
    without_J[i] = play_device_faults(kAnchors[i], 0.0, false, kEases_m).excess_J;
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = play_device_faults(kAnchors[at % kAnchors.size()], kGlitches_m[at / kAnchors.size()], false, kEases_m);
  });
  double step_N = 0.0;
  double work_J = 0.0;
  bool touched = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    touched = touched && all[i].touched;
    step_N = std::max(step_N, all[i].step_N);
    work_J = std::max(work_J, std::abs(all[i].excess_J - without_J[i % kAnchors.size()]));
  }
  return {at_most("glitch: device position up to 2 mm off for one tick: force step, worst", touched ? step_N : NAN, "N",
                  0.1),
          at_most("glitch: device position up to 2 mm off for one tick: change of the work on the hand, worst",
                  touched ? 1e3 * work_J : NAN, "mJ", 1.0)};
}

std::vector<Row> measure_silence(const Options& options) {
  std::array<FaultOutcome, kAnchors.size()> all;
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    all[static_cast<std::size_t>(i)] = play_device_faults(kAnchors[static_cast<std::size_t>(i)], 0.0, true, 0.0);
  });
  const double fell_m = std::max(all[0].fell_m, all[1].fell_m);
  return {at_most("tracker silent for 0.5 s in contact: rise or fall of the device, worst",
                  all[0].touched && all[1].touched ? 1e3 * fell_m : NAN, "mm", 3.0)};
}

/// Presses, rubs, leaves the skin, waits above it and presses again.
device::Intention visit_twice(double time_s) {
  const double high_m = 0.05, deep_m = -0.015;
  const double in = eased(time_s - 1.0) - eased((time_s - 3.5) / 0.6) + eased(time_s - 5.5);
  const double rubs_m = 0.01 * std::sin(2.0 * std::numbers::pi * time_s);
  return {{{rubs_m, high_m + (deep_m - high_m) * in, 0.0}}, {}};
}

/// Largest change of the force in one tick [N], less K times (device's motion + encoder step), where K is the skin's
/// stiffness. NaN: the device was too short a time in the skin, or above it.
double encoder_step_N(effects::SkinAnchor anchor, double encoder_m) {
  const auto patient = torso();
  Feed feed({.patient = patient, .pose = [](double) { return capture::PatientPose{}; }, .link = {}, .builder = {}});
  BenchStation station(
      with_skin(anchor), haptic_from_camera(*patient, spots()[0]),
      std::make_unique<ArmHand>(300.0, visit_twice, device::SimulatedDeviceSettings{.encoder_step_m = encoder_m}));
  ForceSteps steps;
  int lifted = 0, felt = 0;
  run(feed, station, 7.5, [&](const Tick& tick) {
    steps.add(tick);
    lifted += tick.control.phase == control::Phase::OutBody ? 1 : 0;
    felt += tick.displayed ? 1 : 0;
  });
  return lifted > 400 && felt > 2000 ? steps.worst_N() - kSkin_N_per_m * encoder_m : NAN;
}

std::vector<Row> measure_encoders(const Options& options) {
  constexpr std::array kEncoders_m{0.13e-6, 5e-6, 20e-6, 55e-6, 100e-6};
  std::array<double, kAnchors.size() * kEncoders_m.size()> all{};
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at] = encoder_step_N(kAnchors[at % kAnchors.size()], kEncoders_m[at / kAnchors.size()]);
  });
  double worst_N = 0.0;
  for (const double step_N : all) worst_N = std::isnan(step_N) ? NAN : std::max(worst_N, step_N);
  return {
      at_most("encoders of 0.13 to 100 um, in and out of contact: force step a tick beyond K (motion + encoder step), "
              "worst",
              worst_N, "N", 0.05)};
}

}  // namespace

std::vector<Study> device_faults() {
  return {{"glitch", measure_glitch}, {"tracker silent", measure_silence}, {"encoders", measure_encoders}};
}

}  // namespace telepalp::bench::hand
