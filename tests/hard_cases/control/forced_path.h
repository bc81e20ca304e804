#pragma once

#include <functional>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/device/breathing_plane.h"
#include "tests/haptic_station/periods.h"
#include "tests/hard_cases/control/felt.h"
#include "tests/hard_cases/control/loop_scene.h"

namespace telepalp::hard_cases {

/// A hand so strong that the end-effector follows it against any force: down from 50 mm over two seconds, and then
/// along `path`.
struct ForcedPath {
  static constexpr double kDown_s = 2.0;

  double seconds = 10.0;
  effects::EffectBank effects = the_skin();
  std::function<Eigen::Vector3d(double since_down_s)> path;
  std::function<ports::SurfaceContact(const Point<HapticBase>&, double)> surface = device::BreathingPlane{};
  std::function<void(const control::ControlOutput&, double now_s)> watch = [](const control::ControlOutput&, double) {};
};

/// The figures of the run, without `fastest_device`, which needs a simulated device.
inline Felt feel(const ForcedPath& scene) {
  control::EncounteredController controller({}, scene.effects);
  device::SimulatedPair at({}, {});
  device::SimulatedPair next({}, {});
  const auto place = [&](device::SimulatedPair& pair, double now_s) {
    const Eigen::Vector3d down_m = (1.0 - now_s / ForcedPath::kDown_s) * 0.05 * Eigen::Vector3d::UnitY();
    const Point<HapticBase> there{now_s < ForcedPath::kDown_s ? Eigen::Vector3d(scene.path(0.0) + down_m)
                                                              : scene.path(now_s - ForcedPath::kDown_s)};
    pair.place(there, there);
  };
  Felt felt;
  for (int tick = 0; tick * kTick_s < scene.seconds; ++tick) {
    const double now_s = tick * kTick_s;
    place(at, now_s);
    place(next, now_s + kTick_s);
    control::ControlInput in;
    in.device = in.hand = at.true_device();
    in.device_velocity.v = in.hand_velocity.v = (next.true_device().m - at.true_device().m) / kTick_s;
    in.hand_valid = true;
    in.contact = scene.surface(in.device, now_s);
    const control::ControlOutput out = controller.step(in, kTick_s);
    felt.add(out, at, next, kTick_s);
    scene.watch(out, now_s);
  }
  return felt;
}

}  // namespace telepalp::hard_cases
