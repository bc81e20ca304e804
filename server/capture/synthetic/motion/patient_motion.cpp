#include "server/capture/synthetic/motion/patient_motion.h"

#include <array>
#include <cmath>

#include "server/capture/synthetic/motion/quintic_step.h"
#include "server/capture/synthetic/motion/seeded_draw.h"

namespace telepalp::capture {
namespace {

constexpr std::array kMotions{Motion::Regular, Motion::Irregular, Motion::Cough, Motion::Hold,
                              Motion::Speech,  Motion::Shift,     Motion::Drift, Motion::SitUp};
constexpr std::array<std::string_view, kMotions.size()> kNames{"regular", "irregular", "cough", "hold",
                                                               "speech",  "shift",     "drift", "sit-up"};

/// A time slot of fixed length with one event. The slot's number identifies the event.
struct Slot {
  std::int64_t number;
  double from_begin_s;
};
Slot slot_at(SessionTime time, double length_s) noexcept {
  const std::int64_t length_ns = from_seconds(length_s).count();
  const std::int64_t now_ns = to_nanoseconds(time);
  std::int64_t number = now_ns / length_ns;
  if (now_ns % length_ns < 0) --number;
  return {number, 1e-9 * static_cast<double>(now_ns - number * length_ns)};
}

/// A smooth step from 0 to 1 that begins at `begins_s` and takes `takes_s`.
Changing ramp(double now_s, double begins_s, double takes_s) noexcept {
  const Changing step = quintic_step((now_s - begins_s) / takes_s);
  return {step.value, step.rate / takes_s};
}

constexpr double kHoldSlot_s = 20.0;
constexpr double kHoldFlat_s = 7.5;
constexpr double kHoldBegins_s = 0.3;
constexpr double kHoldEnds_s = 0.4;

/// Integral of 1 - quintic_step over [0, t], for t in [0, 1].
double slowing(double t) noexcept { return t - t * t * t * t * (2.5 - 3.0 * t + t * t); }

/// The time of the breath and its rate; it stands still while the breath is held.
Changing held_clock(SessionTime time, std::uint64_t seed) noexcept {
  const Slot slot = slot_at(time, kHoldSlot_s);
  const double onset_s = seeded_draw(seed, slot.number, 20, 4.0, 9.0);
  const double slows = std::clamp((slot.from_begin_s - onset_s) / kHoldBegins_s, 0.0, 1.0);
  const double resumes_s = onset_s + kHoldBegins_s + kHoldFlat_s;
  const double resumes = std::clamp((slot.from_begin_s - resumes_s) / kHoldEnds_s, 0.0, 1.0);
  const double lost_s = kHoldFlat_s + 0.5 * (kHoldBegins_s + kHoldEnds_s);
  double clock_s = std::min(slot.from_begin_s, onset_s) + kHoldBegins_s * slowing(slows);
  clock_s += kHoldEnds_s * (resumes - slowing(resumes));
  clock_s += std::max(0.0, slot.from_begin_s - resumes_s - kHoldEnds_s);
  const double speed = 1.0 - quintic_step(slows).value + (resumes > 0.0 ? quintic_step(resumes).value : 0.0);
  return {static_cast<double>(slot.number) * (kHoldSlot_s - lost_s) + clock_s, speed};
}

/// One to four coughs in a row: the belly jerks out and falls back.
void add_coughs(SessionTime time, std::uint64_t seed, Breath& breath) noexcept {
  const Slot slot = slot_at(time, 6.0);
  const double first_s = seeded_draw(seed, slot.number, 30, 0.5, 3.5);
  const int coughs = static_cast<int>(seeded_draw(seed, slot.number, 31, 1.0, 5.0));
  for (int i = 0; i < coughs; ++i) {
    const auto which = static_cast<std::uint64_t>(32 + 2 * i);
    const double height_m = seeded_draw(seed, slot.number, which, 0.004, 0.010);
    const double begins_s = first_s + 0.45 * i;
    const double rises_s = seeded_draw(seed, slot.number, which + 1, 0.06, 0.12);
    const Changing up = ramp(slot.from_begin_s, begins_s, rises_s);
    const Changing down = ramp(slot.from_begin_s, begins_s + rises_s, 0.25);
    breath.lift_m += height_m * (up.value - down.value);
    breath.speed_m_per_s += height_m * (up.rate - down.rate);
  }
}

/// The pose after the move in slot `number`.
PatientPose settled(std::uint64_t seed, std::int64_t number, double slide_m, double least_rise_m, double most_rise_m) {
  PatientPose pose;
  pose.slide_m = {seeded_draw(seed, number, 40, -slide_m, slide_m), seeded_draw(seed, number, 41, -slide_m, slide_m)};
  pose.rise_m = seeded_draw(seed, number, 42, least_rise_m, most_rise_m);
  return pose;
}

/// Adds the move from one pose to the next.
void add_move(const PatientPose& from, const PatientPose& to, const Changing& done, PatientPose& pose) noexcept {
  pose.slide_m = from.slide_m + done.value * (to.slide_m - from.slide_m);
  pose.slide_m_per_s = done.rate * (to.slide_m - from.slide_m);
  pose.rise_m = from.rise_m + done.value * (to.rise_m - from.rise_m);
  pose.rise_m_per_s = done.rate * (to.rise_m - from.rise_m);
}

void add_shift(SessionTime time, std::uint64_t seed, PatientPose& pose) noexcept {
  const Slot slot = slot_at(time, 6.0);
  const double begins_s = seeded_draw(seed, slot.number, 43, 0.0, 4.0);
  const double takes_s = seeded_draw(seed, slot.number, 44, 0.4, 0.9);
  add_move(settled(seed, slot.number - 1, 0.014, -0.01, 0.02), settled(seed, slot.number, 0.014, -0.01, 0.02),
           ramp(slot.from_begin_s, begins_s, takes_s), pose);
}

void add_drift(SessionTime time, std::uint64_t seed, PatientPose& pose) noexcept {
  constexpr double kSlot_s = 10.0;
  const Slot slot = slot_at(time, kSlot_s);
  add_move(settled(seed, slot.number - 1, 0.0, -0.005, 0.005), settled(seed, slot.number, 0.0, -0.005, 0.005),
           ramp(slot.from_begin_s, 0.0, kSlot_s), pose);
}

void add_sit_up(SessionTime time, std::uint64_t seed, PatientPose& pose) noexcept {
  const Slot slot = slot_at(time, 30.0);
  const auto draw = [&](std::uint64_t which, double least, double most) {
    return seeded_draw(seed, slot.number, which, least, most);
  };
  const double tilt = draw(50, 0.25, 0.45);
  const double begins_s = draw(51, 8.0, 12.0);
  const double rises_s = draw(52, 1.5, 2.5);
  const Changing up = ramp(slot.from_begin_s, begins_s, rises_s);
  const Changing down = ramp(slot.from_begin_s, begins_s + rises_s + draw(53, 5.0, 8.0), 2.0);
  pose.tilt = tilt * (up.value - down.value);
  pose.tilt_per_s = tilt * (up.rate - down.rate);
}

BreathStyle style_of(Motion motion, double amplitude_m, double rate_hz) {
  BreathStyle style{.amplitude_m = amplitude_m, .rate_hz = rate_hz};
  if (motion != Motion::Speech) return style;
  style.rate_hz = 0.8 * rate_hz;  // a phrase is longer than a breath at rest
  style.least_inhale = 0.1;
  style.most_inhale = 0.18;
  style.most_pause = 0.05;
  style.ripple_m = 0.08 * amplitude_m;
  return style;
}

}  // namespace

std::string_view name(Motion motion) noexcept { return kNames[static_cast<std::size_t>(motion)]; }

std::optional<Motion> motion_named(std::string_view wanted) noexcept {
  for (const Motion motion : kMotions)
    if (name(motion) == wanted) return motion;
  return std::nullopt;
}

std::span<const Motion> all_motions() noexcept { return kMotions; }

PatientMotion::PatientMotion(Motion motion, double amplitude_m, double rate_hz, std::uint64_t seed)
    : motion_(motion),
      amplitude_m_(amplitude_m),
      rate_hz_(rate_hz),
      seed_(seed),
      breaths_(style_of(motion, amplitude_m, rate_hz), seed) {}

PatientPose PatientMotion::at(SessionTime time) const noexcept {
  if (motion_ == Motion::Regular) return {.breath = breath_at(time, amplitude_m_, rate_hz_)};
  PatientPose pose;
  if (breaths_.duration_s() > 0.0) {
    const Changing clock = motion_ == Motion::Hold ? held_clock(time, seed_)
                                                   : Changing{slot_at(time, breaths_.duration_s()).from_begin_s, 1.0};
    pose.breath = breaths_.at(clock.value, clock.rate);
  }
  if (motion_ == Motion::Cough) add_coughs(time, seed_, pose.breath);
  if (motion_ == Motion::Shift) add_shift(time, seed_, pose);
  if (motion_ == Motion::Drift) add_drift(time, seed_, pose);
  if (motion_ == Motion::SitUp) add_sit_up(time, seed_, pose);
  return pose;
}

}  // namespace telepalp::capture
