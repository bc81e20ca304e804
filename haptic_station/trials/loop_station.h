#pragma once

#include "haptic_station/core/tick_stage.h"
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
        ticks_(settings.control, settings.effects, {.touch = {}, .hand = settings.estimate}),
        pair_(settings.device, settings.hand),
        tracker_(settings.tracker, settings.seed) {}

  void place(const Point<HapticBase>& device, const Point<HapticBase>& hand) noexcept { pair_.place(device, hand); }

  /// Runs one tick. `device::Intention person(const device::TrialView&)` gives the hand's intended position.
  template <class Person>
  loop::TickOut step(Person&& person) {
    const double now_s = time_s();
    const loop::TickIn due{.now = SessionTime{from_seconds(now_s)},
                           .dt_s = settings_.tick_s,
                           .surface = skin_.newer(now_s, pair_.device())};
    HeldPair<Person> rig(*this, person);
    const loop::TickOut act = ticks_.run(rig, due);
    ++tick_;
    return act;
  }

  [[nodiscard]] double time_s() const noexcept { return static_cast<double>(tick_) * settings_.tick_s; }
  [[nodiscard]] double tick_s() const noexcept { return settings_.tick_s; }
  [[nodiscard]] const device::SimulatedPair& pair() const noexcept { return pair_; }
  /// Depth of the device below the true skin [m]; negative outside.
  [[nodiscard]] double true_depth_m() const { return skin_.true_depth_m(pair_.true_device(), time_s()); }

 private:
  /// The simulated device and tracker, and the person who holds the device at this tick.
  template <class Person>
  class HeldPair final : public ports::Rig {
   public:
    HeldPair(LoopStation& station, Person& person) noexcept : station_(station), person_(person) {}
    ports::DeviceReading read() noexcept override {
      return {.at = station_.pair_.device(), .velocity = station_.pair_.device_velocity()};
    }
    std::optional<ports::HandSample> hand(SessionTime now) noexcept override {
      const auto sample = station_.tracker_.sample(station_.time_s(), station_.pair_.true_hand());
      return sample ? std::optional(ports::HandSample{now, *sample}) : std::nullopt;
    }
    void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double dt_s) noexcept override {
      const device::TrialView view{station_.time_s(), contact, station_.pair_.device()};
      station_.pair_.step(wrench.force, person_(view), dt_s);
    }

   private:
    LoopStation& station_;
    Person& person_;
  };

  VirtualStationSettings settings_;
  TrialSkin& skin_;
  core::TickStage ticks_;
  device::SimulatedPair pair_;
  device::SimulatedTracker tracker_;
  std::uint64_t tick_ = 0;
};

}  // namespace telepalp::trials
