#pragma once

#include <algorithm>

#include "haptic_station/control/safety/virtual_tool.h"
#include "haptic_station/device/random.h"

namespace telepalp::control {

inline constexpr double kNeedleTick_s = 0.0005;
inline const Eigen::Vector3d kNeedleTip_m{0.0, -0.1, 0.0};

/// A needle of 0.1 m over a membrane of 500 N/m at y = 0 that never tears.
inline effects::EffectBank needle_over_membrane() {
  effects::EffectBank bank;
  (void)bank.add(effects::Membrane({.at = {}, .tears_at_N = 1e9, .friction_N = 0.0, .tip_m = kNeedleTip_m}));
  effects::EffectInput in;
  in.device.m = {0.0, 0.2, 0.0};
  bank.begin(in);
  (void)bank.step(in, kNeedleTick_s);
  return bank;
}

inline effects::EffectInput needle_input(const Eigen::Vector3d& device_m) {
  effects::EffectInput in;
  in.device.m = device_m;
  in.contact.normal.v = Eigen::Vector3d::UnitY();
  return in;
}

/// The attitude that the effects see.
enum class Handles { VirtualTool, DeviceAttitude };

struct ClosedPaths {
  int steps = 0;
  double gained_J = 0.0;     ///< work of the displayed force on the hand, over all laps
  double worst_lap_J = 0.0;  ///< of one lap
  double felt_N = 0.0;       ///< largest force
};

/// Laps of a needle on a device that measures six degrees and drives three. A lap begins and ends above the membrane
/// with an upright needle. Between, the hand moves or turns it at random, and then
/// levers it. A step moves the needle by at most 0.02 mm, or turns it by at most 2 mrad. The hand's work is that of the
/// displayed force alone, by the trapezium rule.
inline ClosedPaths closed_paths(std::uint64_t seed, int least_steps, Handles handles) {
  using Eigen::Quaterniond;
  using Eigen::Vector3d;
  device::Random random(seed);
  ClosedPaths seen;
  effects::EffectBank bank = needle_over_membrane();
  VirtualTool tool;
  Vector3d at_m{0.0, 0.105, 0.0};
  Vector3d tilt_rad = Vector3d::Zero();
  Vector3d last_N = Vector3d::Zero();
  double lap_J = 0.0;
  tool.begin(Quaterniond::Identity());
  const auto step = [&](const Vector3d& hop_m, const Vector3d& by_rad) {
    at_m += hop_m;
    tilt_rad += by_rad;
    const Quaterniond attitude = turned(Quaterniond::Identity(), tilt_rad);
    effects::EffectInput in = needle_input(at_m);
    if (handles == Handles::VirtualTool)
      in = tool.turn(in, attitude, bank, false, kNeedleTick_s);
    else
      in.turn.attitude = attitude;
    const Vector3d force_N = bank.step(in, kNeedleTick_s).force.N;
    lap_J += 0.5 * (force_N + last_N).dot(hop_m);
    last_N = force_N;
    seen.felt_N = std::max(seen.felt_N, force_N.norm());
    ++seen.steps;
  };
  const auto move = [&](const Vector3d& to_m) {
    const int hops = 1 + static_cast<int>((to_m - at_m).norm() / 2e-5);
    const Vector3d hop_m = (to_m - at_m) / hops;
    for (int i = 0; i < hops; ++i) step(hop_m, Vector3d::Zero());
  };
  const auto turn = [&](const Vector3d& to_rad) {
    const int hops = 1 + static_cast<int>((to_rad - tilt_rad).norm() / 2e-3);
    const Vector3d by_rad = (to_rad - tilt_rad) / hops;
    for (int i = 0; i < hops; ++i) step(Vector3d::Zero(), by_rad);
  };
  // The needle lies down, is lowered beside the membrane, set upright without work, and pushed out.
  const auto lever = [&] {
    turn({1.2, 0.0, 0.0});
    move({0.0, 0.06, 0.0});
    turn(Vector3d::Zero());
    move({0.0, 0.105, 0.0});
  };
  while (seen.steps < least_steps) {
    lap_J = 0.0;
    for (int leg = 0; leg < 4; ++leg) {
      turn({random.uniform(-1.2, 1.2), 0.0, random.uniform(-1.2, 1.2)});
      move({random.uniform(-0.01, 0.01), random.uniform(0.06, 0.1), random.uniform(-0.01, 0.01)});
    }
    move({0.0, 0.105, 0.0});
    lever();
    seen.gained_J += lap_J;
    seen.worst_lap_J = std::max(seen.worst_lap_J, lap_J);
  }
  return seen;
}

}  // namespace telepalp::control
