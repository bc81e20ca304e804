#pragma once

#include <optional>
#include <variant>

#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/device/simulated_tracker.h"
#include "haptic_station/device/simulated_wrist.h"
#include "haptic_station/device/trial.h"
#include "haptic_station/ports/rig.h"
#include "haptic_station/tracking/hand_trace.h"

namespace telepalp::loop {

/// A simulated device, a simulated hand that holds it, and a simulated tracker that observes the hand. The hand follows
/// the scripted path of a trial or repeats a recorded movement; a recorded attitude takes precedence over
/// Settings::wrist. The station runs this class on the haptic thread; tests step it in virtual time.
class SimulatedRig final : public ports::Rig {
 public:
  struct Settings {
    device::SimulatedDeviceSettings device;
    device::SimulatedHandSettings hand;
    device::SimulatedTrackerSettings tracker;
    std::optional<device::SimulatedWristSettings> wrist = {};  ///< nullopt: the hand's attitude is not measured
    Point<HapticBase> rest;                                    ///< start position of device and hand
    std::uint64_t seed = 1;
  };
  using Person = std::variant<device::ScriptedIntention, tracking::RecordedIntention>;

  SimulatedRig(const Settings& settings, Person person) noexcept;

  [[nodiscard]] ports::DeviceReading read() noexcept override;
  [[nodiscard]] std::optional<ports::HandSample> hand(SessionTime now) noexcept override;
  void catch_up(double missed_s) noexcept override;
  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double dt_s) noexcept override;

  [[nodiscard]] const device::SimulatedPair& pair() const noexcept { return pair_; }

 private:
  [[nodiscard]] std::optional<Eigen::Quaterniond> attitude() const noexcept;

  device::SimulatedPair pair_;
  device::SimulatedTracker tracker_;
  std::optional<device::SimulatedWristSettings> wrist_;
  Person person_;
  double time_s_ = 0.0;
  Wrench<HapticBase> last_wrench_;
  ports::SurfaceContact last_contact_;
};

}  // namespace telepalp::loop
