#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <utility>

#include "haptic_station/core/tick_stage.h"
#include "haptic_station/loop/plane_snapshot.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// Devices whose readings are late press a wall that is stiffer than any of them can display. The station knows the
// delay of the device's loop from the readings, and limits the stiffness by it.

namespace telepalp::bench::hand {
namespace {

constexpr double kWall_N_per_m = 20'000.0;
constexpr double kEncoder_m = 1e-6;
constexpr double kPushed_s = 4.0;  // the device is moved into the wall until then, and then it is free
constexpr double kLoopLasts_s = 10.0;
constexpr double kPush_N = 1.0;
constexpr double kKnock_m_per_s = 0.005;

struct Device {
  double mass_kg;
  double b;            ///< damping [N s/m]
  int delay_ticks;     ///< age of each reading [ticks]
  double arm_N_per_m;  ///< spring that holds the free device; 0: no arm
};

struct LoopOutcome {
  /// Stiffness that the station sets, divided by b / (T/2 + Td): damping b, tick T, loop delay Td.
  double limit_share = NAN;
  double growth_m = NAN;  ///< width of the free device's motion in its last second less that in its first second
};

/// A device that is moved from the air into the wall, and is then free under a constant push. Its readings state the
/// delay of its loop.
class LateDevice final : public ports::Rig {
 public:
  /// `told_s`: the loop delay that the readings state.
  LateDevice(const Device& device, double told_s)
      : device_(device), told_s_(told_s), readings_(static_cast<std::size_t>(device.delay_ticks), kHigh_m) {}

  [[nodiscard]] ports::DeviceReading read() noexcept override {
    readings_.push_back(std::round(at_m_ / kEncoder_m) * kEncoder_m);
    ports::DeviceReading reading;
    reading.at.m.y() = readings_.front();
    reading.loop_s = told_s_;
    readings_.pop_front();
    return reading;
  }
  [[nodiscard]] std::optional<ports::HandSample> hand(SessionTime now) noexcept override {
    if (ticks_ % 20 != 0) return std::nullopt;
    return ports::HandSample{.at = now, .hand = {{0.0, at_m_, 0.0}}};
  }
  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact&, double) noexcept override {
    const double force_N = wrench.force.N.y();
    if (is_free())
      move(force_N);
    else
      push_in(force_N);
    ++ticks_;
  }
  [[nodiscard]] double at_m() const { return at_m_; }
  [[nodiscard]] double free_s() const { return ticks_ * kTick_s - kPushed_s; }
  [[nodiscard]] bool is_free() const { return free_s() >= 0.0; }

 private:
  static constexpr double kHigh_m = 0.01;

  void push_in(double force_N) noexcept {
    if (ticks_ * kTick_s > 1.0 && (at_m_ > 0.0 || force_N < kPush_N)) at_m_ -= 0.02 * kTick_s;
    held_N_ = force_N;
    rest_m_ = at_m_;
    speed_ = kKnock_m_per_s;
  }
  void move(double force_N) noexcept {
    constexpr int kParts = 20;
    for (int part = 0; part < kParts; ++part) {
      const double arm_N = device_.arm_N_per_m * (rest_m_ - at_m_) - held_N_;
      speed_ += (force_N + arm_N - device_.b * speed_) / device_.mass_kg * kTick_s / kParts;
      at_m_ += speed_ * kTick_s / kParts;
    }
  }

  Device device_;
  double told_s_;
  std::deque<double> readings_;
  int ticks_ = 0;
  double at_m_ = kHigh_m, speed_ = 0.0, held_N_ = 0.0, rest_m_ = kHigh_m;
};

/// Widths of a motion in its first and in its last second.
class Widths {
 public:
  void add(double since_s, double at_m) {
    if (since_s < 1.0) early_.add(at_m);
    if (since_s > kLoopLasts_s - kPushed_s - 1.0) late_.add(at_m);
  }
  [[nodiscard]] double growth_m() const { return late_.width_m() - early_.width_m(); }

 private:
  struct Range {
    double least_m = HUGE_VAL, most_m = -HUGE_VAL;
    void add(double at_m) {
      least_m = std::min(least_m, at_m);
      most_m = std::max(most_m, at_m);
    }
    [[nodiscard]] double width_m() const { return most_m - least_m; }
  };
  Range early_, late_;
};

core::TickStage station_at_wall(double believed_b) {
  control::ControlSettings control;
  control.coupling.device_damping_N_s_per_m = believed_b;
  effects::EffectBank bank;
  (void)bank.add(effects::Skin({.law = effects::linear_law(kWall_N_per_m)}));
  return {control, bank};
}

/// `wrong`: relative error of the damping that the station believes, and of the delay that it measures.
LoopOutcome play_device_loop(const Device& device, double wrong) {
  core::TickStage station = station_at_wall(device.b * (1.0 + wrong));
  const double delay_s = device.delay_ticks * kTick_s;
  LateDevice late(device, delay_s * (1.0 - wrong));
  loop::TouchableSurface wall, before_wall;  // the station reads before_wall until it has wall
  Widths widths;
  for (int tick = 0; tick * kTick_s < kLoopLasts_s; ++tick) {
    loop::TickIn due{.now = at_time(tick * kTick_s), .dt_s = kTick_s};
    if (tick % 67 == 0) {
      auto newer = std::make_shared<loop::PlaneSnapshot>(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY(), 1.0);
      newer->captured = due.now;
      before_wall = std::exchange(wall, {std::move(newer), {}});
      due.surface = &wall;
    }
    (void)station.run(late, due);
    if (late.is_free()) widths.add(late.free_s(), late.at_m());
  }
  const control::EncounteredController& controller = station.loop().controller();
  const double theory = device.b / (0.5 * kTick_s + delay_s);
  return {controller.touching() ? controller.coupling().stiffness_N_per_m() / theory : NAN, widths.growth_m()};
}

std::vector<Device> devices() {
  std::vector<Device> all;
  for (const int delay_ticks : {0, 1, 2, 4, 8})
    for (const double b : {0.3, 1.0, 3.0})
      for (const double mass_kg : {0.1, 0.3, 1.0})
        for (const double arm_N_per_m : {0.0, 300.0}) all.push_back({mass_kg, b, delay_ticks, arm_N_per_m});
  return all;
}

std::vector<Row> measure_device_loop(const Options& options) {
  const std::vector<Device> tried = devices();
  std::vector<LoopOutcome> right(tried.size()), wrong(tried.size());
  for_each_parallel(static_cast<int>(tried.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    right[at] = play_device_loop(tried[at], 0.0);
    wrong[at] = play_device_loop(tried[at], 0.3);
  });
  double least = HUGE_VAL, most = 0.0, growth_m = -HUGE_VAL;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const bool touched = std::isfinite(right[i].limit_share) && std::isfinite(wrong[i].limit_share);
    least = touched ? std::min(least, right[i].limit_share) : NAN;
    most = touched ? std::max(most, right[i].limit_share) : NAN;
    growth_m = touched ? std::max({growth_m, right[i].growth_m, wrong[i].growth_m}) : NAN;
  }
  const std::string name = "device loop, delay 0-4 ms, b 0.3-3 N s/m, 0.1-1 kg, with and without an arm: ";
  return {at_least(name + "stiffness that the station sets over b / (T/2 + Td), least", least, "", 0.45),
          at_most(name + "the same, most", most, "", 0.55),
          at_most(name + "growth of a motion, also with b and Td wrong by 30 %, most", 1e6 * growth_m, "um",
                  1e6 * kEncoder_m)};
}

}  // namespace

std::vector<Study> device_loop() { return {{"device loop", measure_device_loop}}; }

}  // namespace telepalp::bench::hand
