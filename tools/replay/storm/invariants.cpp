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
constexpr double kMostGained_J = 0.02;     // a wrong prediction of the skin may give the hand this much
constexpr double kMostGainedShare = 0.05;  // of the work that device and hand exchanged in the contact
constexpr double kStep_N = 0.05;           // change of the force in a tick beyond what the device's motion explains
constexpr double kLetsGoStep_N = 0.1;      // the same while the station lets go
constexpr Nanoseconds kFades = 10ms;       // after a change of contact or phase, the limiter alone bounds the change
constexpr float kNew_s = 0.5F;             // age of a surface that note_weak() still judges
constexpr float kSmallLaw_N = 0.2F;        // note_weak() does not judge smaller forces of the true skin
constexpr float kSurelyStale_s = 2.5F;     // past the limit of 1 s, the fade of 0.5 s and the dwell
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

Invariants::Invariants(const Scenario& scenario, const control::ControlSettings& control, double stiffest_N_per_m)
    : control_(control),
      stiffest_N_per_m_(stiffest_N_per_m),
      calm_from_(end_of(scenario.faults) + kSettle + scenario.down.delay) {}

void Invariants::violated(std::string what) {
  if (!violation_) violation_ = Violation{now(), std::move(what)};
}

void Invariants::check_force(const TickRecord& tick) {
  if (!tick.force_N.allFinite()) return violated("the force is not finite (NaN or infinite)");
  const double force_N = double{tick.force_N.norm()};
  if (force_N > kRounding * control_.limits.peak_N)
    violated(with_number("the force is %.3f N, above the scene's limits.peak_N", force_N));
  const double step_N = double{(tick.force_N - last_force_N_).norm()};
  const double most_N = most_step_N(tick);
  if (step_N > kRounding * most_N + 1e-6)
    violated(with_number("the force changes by %.3f N in a tick, ", step_N) +
             with_number("more than its motion explains (limit %.3f N)", most_N));
}

/// The largest change of force [N] that this tick may have: what the device's motion explains, and a margin. For 10 ms
/// after a change of contact or phase, the force may fade as fast as the limiter allows.
double Invariants::most_step_N(const TickRecord& tick) noexcept {
  const bool changed = tick.touching != was_touching_ || tick.phase != last_phase_;
  unchanged_ = changed ? 0ns : unchanged_ + kTick;
  last_phase_ = tick.phase;
  if (unchanged_ < kFades && ticks_ > 0) return control_.limits.slew_N_per_s * to_seconds(kTick);
  const double motion_N = ticks_ == 0 ? 0.0 : stiffest_N_per_m_ * (tick.device_m - last_device_m_).norm();
  return motion_N + (control::has_let_go(tick.phase) ? kLetsGoStep_N : kStep_N);
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
  const double work_J = was_touching_ ? last_force_N_.cast<double>().dot(tick.device_m - last_device_m_) : 0.0;
  if (tick.touching && !was_touching_) worked_J_ = exchanged_J_ = 0.0;
  worked_J_ += work_J;
  exchanged_J_ += std::abs(work_J);
  was_touching_ = tick.touching;
  last_device_m_ = tick.device_m;
  const double gained_J = std::min(worked_J_, double{tick.hand_excess_J});
  ledgers_.most_gained_J = std::max(ledgers_.most_gained_J, gained_J);
  const double most_J = std::max(kMostGained_J, kMostGainedShare * exchanged_J_);
  if (gained_J > most_J)
    violated(with_number("the device gave the hand %.4f J in this contact ", gained_J) +
             with_number("that the measured skin would not have given (limit %.4f J)", most_J));
}

/// Adds up the time in this contact in which the hand feels less than half of the true skin's force, although the
/// surface is younger than 0.5 s. Storms print the longest time; it is no violation.
void Invariants::note_weak(const TickRecord& tick) noexcept {
  if (!tick.felt) weak_ = 0ns;
  const bool weak =
      tick.felt && tick.surface_age_s < kNew_s && tick.law_N > kSmallLaw_N && tick.off_truth_N < -0.5F * tick.law_N;
  if (weak) weak_ += kTick;
  ledgers_.longest_weak_s = std::max(ledgers_.longest_weak_s, to_seconds(weak_));
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
  note_weak(tick);
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
