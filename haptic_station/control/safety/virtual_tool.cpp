#include "haptic_station/control/safety/virtual_tool.h"

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kFastest_rad_per_s = 20.0;  // of a tool that is not at the device's attitude
constexpr double kReached_rad = 1e-9;

effects::EffectInput with_attitude(const effects::EffectInput& in, const Quaterniond& attitude) noexcept {
  effects::EffectInput out = in;
  out.turn.attitude = attitude;
  return out;
}

/// The derivative of the effects' energy by the tool's rotation [J/rad].
Vector3d slope_J(const effects::EffectInput& in, const effects::EffectBank& effects, double here_J) noexcept {
  constexpr double kHop_rad = 1e-5;
  Vector3d slope;
  for (int axis = 0; axis < 3; ++axis)
    slope[axis] =
        (effects.loaded_J(with_attitude(in, turned(in.turn.attitude, kHop_rad * Vector3d::Unit(axis)))) - here_J) /
        kHop_rad;
  return slope;
}

/// The largest of some shares of `wanted_rad` that does not raise the effects' energy above `here_J`.
Vector3d without_load(const effects::EffectInput& in, const effects::EffectBank& effects, double here_J,
                      const Vector3d& wanted_rad) noexcept {
  for (double share = 1.0; share > 0.1; share *= 0.5) {
    const Vector3d turn_rad = share * wanted_rad;
    if (effects.loaded_J(with_attitude(in, turned(in.turn.attitude, turn_rad))) <= here_J) return turn_rad;
  }
  return Vector3d::Zero();
}

/// The tool's rotation towards `wanted_rad` that does not load the effects. Where they oppose it, the tool slides along
/// their slope, and a little down it, because the slope curves.
Vector3d free_turn(const effects::EffectInput& in, const effects::EffectBank& effects,
                   const Vector3d& wanted_rad) noexcept {
  constexpr double kDown = 0.1;
  if (wanted_rad.isZero(0.0)) return wanted_rad;
  const double here_J = effects.loaded_J(in);
  const Vector3d straight_rad = without_load(in, effects, here_J, wanted_rad);
  if (!straight_rad.isZero(0.0)) return straight_rad;
  const Vector3d up = slope_J(in, effects, here_J).stableNormalized();
  const Vector3d along_rad = wanted_rad - wanted_rad.dot(up) * up;
  return without_load(in, effects, here_J, along_rad - kDown * along_rad.norm() * up);
}

}  // namespace

void VirtualTool::begin(const std::optional<Quaterniond>& device) noexcept {
  if (device) attitude_ = *device;
  reached_ = device.has_value();
  shows_torque_ = false;
}

effects::EffectInput VirtualTool::turn(const effects::EffectInput& at_device, const std::optional<Quaterniond>& device,
                                       const effects::EffectBank& effects, bool gives_torque, double dt_s) noexcept {
  effects::EffectInput in = with_attitude(at_device, attitude_);
  shows_torque_ = device && gives_torque && reached_;
  if (!device) {
    reached_ = false;
    return in;
  }
  const Vector3d gap_rad = turned_rad(attitude_, *device);
  const bool is_free = shows_torque_ || !effects.feels_attitude();
  const Vector3d turn_rad = is_free ? gap_rad : free_turn(in, effects, at_most(gap_rad, kFastest_rad_per_s * dt_s));
  in.turn.turned.v = turn_rad;
  in.turn.attitude = attitude_ = is_free ? *device : turned(attitude_, turn_rad);
  reached_ = (gap_rad - turn_rad).norm() <= kReached_rad;
  return in;
}

}  // namespace telepalp::control
