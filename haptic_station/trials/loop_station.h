#pragma once

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/trials/trial_skin.h"
#include "haptic_station/trials/virtual_station.h"

namespace telepalp::trials {

/// The station's haptic loop on a simulated device, in virtual time: surface snapshots, hand samples and ticks, without
/// the station's clock and threads. The caller supplies the person, and the skin, which must outlive this object.
class LoopStation {
 public:
  LoopStation(const VirtualStationSettings& settings, TrialSkin& skin)
      : settings_(settings),
        skin_(skin),
        loop_({.touch = {}, .hand = settings.estimate}, {settings.control, settings.effects}),
        pair_(settings.device, settings.hand),
        tracker_(settings.tracker, settings.seed) {}

  void place(const Point<HapticBase>& device, const Point<HapticBase>& hand) noexcept { pair_.place(device, hand); }

  /// Runs one tick. `device::Intention person(const device::TrialView&)` gives the hand's intended position.
  template <class Person>
  loop::TickOut step(Person&& person) {
    const double now_s = time_s();
    const SessionTime now{from_seconds(now_s)};
    loop::TickIn in{.now = now,
                    .dt_s = settings_.tick_s,
                    .reading = {.at = pair_.device(), .velocity = pair_.device_velocity()},
                    .surface = skin_.newer(now_s, pair_.device())};
    if (const auto sample = tracker_.sample(now_s, pair_.true_hand())) in.hand = {now, *sample};
    const loop::TickOut act = loop_.tick(in);
    pair_.step(act.force, person(device::TrialView{now_s, act.contact, pair_.device()}), settings_.tick_s);
    ++tick_;
    return act;
  }

  [[nodiscard]] double time_s() const noexcept { return static_cast<double>(tick_) * settings_.tick_s; }
  [[nodiscard]] double tick_s() const noexcept { return settings_.tick_s; }
  [[nodiscard]] const device::SimulatedPair& pair() const noexcept { return pair_; }
  /// Depth of the device below the true skin [m]; negative outside.
  [[nodiscard]] double true_depth_m() const { return skin_.true_depth_m(pair_.true_device(), time_s()); }

 private:
  VirtualStationSettings settings_;
  TrialSkin& skin_;
  loop::HapticLoop loop_;
  device::SimulatedPair pair_;
  device::SimulatedTracker tracker_;
  std::uint64_t tick_ = 0;
};

}  // namespace telepalp::trials
