#pragma once

#include <functional>
#include <optional>

#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/device/simulated_tracker.h"
#include "haptic_station/loop/tick.h"

namespace telepalp::bench::hand {

inline constexpr double kArm_N_per_m = 300.0;  ///< stiffness of a person's arm

/// A person at the haptic device: determines the positions of device and hand under a force.
class Person {
 public:
  virtual ~Person() = default;
  [[nodiscard]] virtual ports::DeviceReading read() const noexcept = 0;
  [[nodiscard]] virtual Point<HapticBase> device() const noexcept = 0;  ///< true position, without sensor errors
  [[nodiscard]] virtual Point<HapticBase> hand() const noexcept = 0;
  virtual void apply(const loop::TickOut& act, double time_s, double dt_s) = 0;
};

/// A hand that no force moves: the device follows `path`, which may depend on the controller's last output.
class RigidHand final : public Person {
 public:
  using Path = std::function<Point<HapticBase>(double time_s, const control::ControlOutput& last)>;
  explicit RigidHand(Path path) : path_(std::move(path)) { at_ = path_(0.0, {}); }

  [[nodiscard]] ports::DeviceReading read() const noexcept override { return {at_, velocity_, 0.0}; }
  [[nodiscard]] Point<HapticBase> device() const noexcept override { return at_; }
  [[nodiscard]] Point<HapticBase> hand() const noexcept override { return at_; }
  void apply(const loop::TickOut& act, double time_s, double dt_s) override {
    const Point<HapticBase> next = path_(time_s + dt_s, act.control);
    velocity_.v = (next.m - at_.m) / dt_s;
    at_ = next;
  }

 private:
  Path path_;
  Point<HapticBase> at_;
  Vector<HapticBase> velocity_;
};

/// A hand on an arm that yields to force, at the simulated device; `aim` gives the intended position.
class ArmHand final : public Person {
 public:
  using Aim = std::function<device::Intention(double time_s)>;
  ArmHand(double arm_N_per_m, Aim aim, const device::SimulatedDeviceSettings& device = {})
      : pair_(device, {.stiffness_N_per_m = arm_N_per_m}), aim_(std::move(aim)) {
    pair_.place(aim_(0.0).at, aim_(0.0).at);
  }
  [[nodiscard]] ports::DeviceReading read() const noexcept override {
    return {pair_.device(), pair_.device_velocity(), 0.0};
  }
  [[nodiscard]] Point<HapticBase> device() const noexcept override { return pair_.true_device(); }
  [[nodiscard]] Point<HapticBase> hand() const noexcept override { return pair_.true_hand(); }
  void apply(const loop::TickOut& act, double time_s, double dt_s) override {
    pair_.step(act.force, aim_(time_s), dt_s);
  }

 private:
  device::SimulatedPair pair_;
  Aim aim_;
};

}  // namespace telepalp::bench::hand
