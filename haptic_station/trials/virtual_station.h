#pragma once

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/device/simulated_tracker.h"
#include "haptic_station/device/trial.h"
#include "haptic_station/tracking/hand_estimate.h"

namespace telepalp::trials {

struct VirtualStationSettings {
  control::ControlSettings control;
  effects::EffectBank effects;
  device::SimulatedDeviceSettings device;
  device::SimulatedHandSettings hand;
  device::SimulatedTrackerSettings tracker;
  tracking::HandEstimateSettings estimate;
  std::uint64_t seed = 1;
  double tick_s = 0.0005;
};

/// Runs tracker, hand estimate, controller and simulated device in virtual time: the station's 2 kHz tick without
/// clock, threads and camera. The caller supplies the surface and the person.
class VirtualStation {
 public:
  explicit VirtualStation(const VirtualStationSettings& settings) noexcept
      : settings_(settings),
        controller_(settings.control, settings.effects),
        pair_(settings.device, settings.hand),
        tracker_(settings.tracker, settings.seed),
        estimate_(settings.estimate) {}

  void place(const Point<HapticBase>& device, const Point<HapticBase>& hand) noexcept { pair_.place(device, hand); }

  /// Runs one tick. `SurfaceContact surface(Point<HapticBase> device, double time_s)` gives the contact of the device
  /// point. `device::Intention person(const device::TrialView&)` gives the hand's intended position and velocity.
  /// `spoil(ControlInput&)` may damage the controller's input, for tests.
  template <class Surface, class Person, class Spoil>
  control::ControlOutput step(Surface&& surface, Person&& person, Spoil&& spoil) noexcept {
    const SessionTime now{from_seconds(time_s())};
    if (const auto sample = tracker_.sample(time_s(), pair_.true_hand())) (void)estimate_.update(now, *sample);
    const tracking::HandPrediction hand = estimate_.predict(now);
    control::ControlInput in;
    in.device = pair_.device();
    in.device_velocity = pair_.device_velocity();
    in.hand = hand.at;
    in.hand_velocity = hand.velocity;
    in.hand_valid = hand.valid;
    in.hand_age_s = hand.age_s;
    in.contact = surface(in.device, time_s());
    const device::TrialView view{time_s(), in.contact, in.device};
    spoil(in);
    const control::ControlOutput out = controller_.step(in, settings_.tick_s);
    pair_.step(out.force, person(view), settings_.tick_s);
    ++tick_;
    return out;
  }
  template <class Surface, class Person>
  control::ControlOutput step(Surface&& surface, Person&& person) noexcept {
    return step(surface, person, [](control::ControlInput&) {});
  }

  [[nodiscard]] double time_s() const noexcept { return static_cast<double>(tick_) * settings_.tick_s; }
  [[nodiscard]] const device::SimulatedPair& pair() const noexcept { return pair_; }
  [[nodiscard]] const control::EncounteredController& controller() const noexcept { return controller_; }

 private:
  VirtualStationSettings settings_;
  control::EncounteredController controller_;
  device::SimulatedPair pair_;
  device::SimulatedTracker tracker_;
  tracking::HandEstimate estimate_;
  std::uint64_t tick_ = 0;
};

}  // namespace telepalp::trials
