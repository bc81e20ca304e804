#include "tools/replay/storm/invariants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "haptic_station/surface/touch/touch.h"
#include "messages/station.pb.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

constexpr double kRounding = 1.001;  // forces are recorded as float
// The damping needs a few ms to take an excess of energy out; docs/replay.md names the worst of the seeds that were
// run.
constexpr float kLeastPassivity_J = -0.005F;
// After a clock step, the displayed skin rises at 50 mm/s under a hand that has sunk 80 mm deep. A tap in that time
// meets it too late, and keeps 0.2 J that the true skin would have absorbed.
constexpr float kMostExcess_J = 0.25F;
constexpr double kMostGained_J = 0.02;  // while the skin's prediction is wrong; the worst seed that was run: 2.3 mJ
constexpr float kSurelyStale_s = 2.5F;  // past the limit of 1 s, the fade of 0.5 s and the dwell
constexpr float kYoung_s = 0.8F;
constexpr float kNoForce_N = 0.05F;
constexpr Nanoseconds kFadeWithin = 500ms;
constexpr float kDeep_m = 0.005F;
constexpr Nanoseconds kSettle = 3s;
constexpr Nanoseconds kFeltWithin = 1500ms;

template <class Faults, class WindowOf>
Nanoseconds last_end(const Faults& faults, WindowOf window_of) {
  Nanoseconds last{0};
  for (const auto& fault : faults) last = std::max(last, window_of(fault).from + window_of(fault).length);
  return last;
}

Nanoseconds end_of(const Faults& faults) {
  const auto itself = [](const Window& window) { return window; };
  const auto when = [](const auto& fault) { return fault.when; };
  return std::max({last_end(faults.outages, itself), last_end(faults.restarts, itself),
                   last_end(faults.tracker_lost, itself), last_end(faults.glitches, when),
                   last_end(faults.clock_steps, when)});
}

std::string with_number(const char* form, double value) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), form, value);
  return text.data();
}

}  // namespace

Invariants::Invariants(const Scenario& scenario, const control::ControlSettings& control)
    : control_(control), calm_from_(end_of(scenario.faults) + kSettle + scenario.down.delay) {}

void Invariants::violated(std::string what) {
  if (!violation_) violation_ = Violation{now(), std::move(what)};
}

void Invariants::check_force(const TickRecord& tick) {
  if (!tick.force_N.allFinite()) return violated("the force is not finite (NaN or infinite)");
  const double force_N = double{tick.force_N.norm()};
  if (force_N > kRounding * control_.limits.peak_N)
    violated(with_number("the force is %.3f N, above the scene's limits.peak_N", force_N));
  const double step_N = double{(tick.force_N - last_force_N_).norm()};
  if (step_N > kRounding * control_.limits.slew_N_per_s * to_seconds(kTick) + 1e-6)
    violated(with_number("the force changes by %.3f N in a tick, faster than the limiter allows", step_N));
}

void Invariants::check_energy(const TickRecord& tick) {
  ledgers_.least_passivity_J = std::min(ledgers_.least_passivity_J, double{tick.passivity_J});
  ledgers_.most_excess_J = std::max(ledgers_.most_excess_J, double{tick.hand_excess_J});
  if (!(tick.passivity_J >= kLeastPassivity_J))
    violated(with_number(
        "the display created energy: energy taken from the hand less energy stored is %.5f J (limit -0.005 J)",
        double{tick.passivity_J}));
  if (!(tick.hand_excess_J <= kMostExcess_J))
    violated(
        with_number("the excess work on the hand is too large: %.4f J (limit 0.25 J) beyond the measured skin's work "
                    "in this contact",
                    double{tick.hand_excess_J}));
}

/// Energy that the device gave the hand in this contact, and the measured skin would not have given: the smaller of the
/// work on the hand and of this work beyond the measured skin's. A skin that is displayed too late takes less work from
/// the hand than the measured one; this is an excess, but the hand gains nothing.
void Invariants::check_gain(const TickRecord& tick) {
  if (was_touching_) worked_J_ += last_force_N_.cast<double>().dot(tick.device_m - last_device_m_);
  if (tick.touching && !was_touching_) worked_J_ = 0.0;
  was_touching_ = tick.touching;
  last_device_m_ = tick.device_m;
  const double gained_J = std::min(worked_J_, double{tick.hand_excess_J});
  ledgers_.most_gained_J = std::max(ledgers_.most_gained_J, gained_J);
  if (gained_J > kMostGained_J)
    violated(with_number(
        "the device gave the hand %.4f J (limit 0.02 J) in this contact that the measured skin would not have given",
        gained_J));
}

void Invariants::check_release(const TickRecord& tick) {
  stale_ = tick.surface_age_s > kSurelyStale_s ? stale_ + kTick : 0ns;
  if (stale_ <= kFadeWithin) return;
  if (!control::has_let_go(tick.phase) || tick.force_N.norm() > kNoForce_N)
    violated(
        with_number("the station still gives force, or is not in phase Released or Faulted; the surface is %.2f s old "
                    "(limit 2.5 s)",
                    double{tick.surface_age_s}));
}

/// A device that the station let go of can fall deeper than a contact may begin. From there, the station must lift it.
void Invariants::check_felt(const TickRecord& tick) {
  const bool is_lifted =
      tick.depth_m > static_cast<float>(surface::kDeepestStart_m) && tick.phase == control::Phase::BodyToPlane;
  const bool unfelt =
      now() > calm_from_ && tick.depth_m > kDeep_m && tick.surface_age_s < kYoung_s && !tick.felt && !is_lifted;
  unfelt_ = unfelt ? unfelt_ + kTick : 0ns;
  if (unfelt_ > kFeltWithin)
    violated(with_number(
        "the device is %.1f mm deep in the skin and has been over 5 mm deep for over 1.5 s, but there is no force",
        1e3 * double{tick.depth_m}));
}

void Invariants::add(const TickRecord& tick) {
  check_force(tick);
  check_energy(tick);
  check_gain(tick);
  check_release(tick);
  check_felt(tick);
  last_force_N_ = tick.force_N;
  ++ticks_;
}

void Invariants::add(const wire::Message& message) {
  SessionTime& newest = published_[message.topic.name];
  if (message.published < newest)
    violated(std::string(message.topic.name) +
             " has a message with an earlier publication time than the message before it");
  newest = std::max(newest, message.published);
  if (message.topic.name != wire::kStationTicks.name) return;
  msg::StationTicks ticks;
  if (!ticks.ParseFromString(*message.payload)) return violated("a message on /station/ticks cannot be parsed");
  if (ticks.first_tick() != next_tick_) violated("ticks are missing or repeated on /station/ticks");
  next_tick_ = ticks.first_tick() + static_cast<std::uint64_t>(ticks.phase_size());
}

std::string in_words(const Invariants::Violation& violation) {
  return with_number("at %.3f s of the run: ", to_seconds(violation.at)) + violation.what;
}

}  // namespace telepalp::replay
