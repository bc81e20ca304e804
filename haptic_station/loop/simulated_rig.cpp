#include "haptic_station/loop/simulated_rig.h"

#include <utility>

namespace telepalp::loop {

SimulatedRig::SimulatedRig(const Settings& settings, Person person) noexcept
    : pair_(settings.device, settings.hand),
      tracker_(settings.tracker, settings.seed),
      wrist_(settings.wrist),
      person_(std::move(person)) {
  pair_.place(settings.rest, settings.rest);
}

ports::DeviceReading SimulatedRig::read() noexcept {
  return {.at = pair_.device(), .velocity = pair_.device_velocity(), .age_s = 0.0};
}

std::optional<ports::HandSample> SimulatedRig::hand(SessionTime now) noexcept {
  const std::optional<Point<HapticBase>> sample = tracker_.sample(time_s_, pair_.true_hand());
  if (!sample) return std::nullopt;
  return ports::HandSample{now, *sample, attitude()};
}

std::optional<Eigen::Quaterniond> SimulatedRig::attitude() const noexcept {
  if (const auto* recorded = std::get_if<tracking::RecordedIntention>(&person_))
    if (const auto measured = recorded->attitude(time_s_)) return measured;
  if (!wrist_) return std::nullopt;
  return device::wrist_attitude(*wrist_, time_s_);
}

void SimulatedRig::catch_up(double missed_s) noexcept { apply(last_wrench_, last_contact_, missed_s); }

void SimulatedRig::apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double dt_s) noexcept {
  last_wrench_ = wrench;
  last_contact_ = contact;
  device::Intention intention;
  if (auto* scripted = std::get_if<device::ScriptedIntention>(&person_))
    intention = scripted->step({.time_s = time_s_, .contact = contact, .device = pair_.device()}, dt_s);
  else if (const auto* recorded = std::get_if<tracking::RecordedIntention>(&person_))
    intention = recorded->at(time_s_);
  pair_.step(wrench.force, intention, dt_s);
  time_s_ += dt_s;
}

}  // namespace telepalp::loop
