#pragma once

#include <functional>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/trials/trial_run.h"
#include "haptic_station/trials/virtual_station.h"
#include "tests/hard_cases/control/felt.h"
#include "tests/hard_cases/control/people.h"

namespace telepalp::hard_cases {

/// The controller in virtual time, with tracker, device and person; the surface is a function. Defaults: S1's skin and
/// cylinder, a level surface at rest at height 0, and a hand that waits above it.
struct ControllerScene {
  double seconds = 4.0;
  trials::VirtualStationSettings settings = trials::paper_settings();
  Point<HapticBase> device{{0.0, 0.03, 0.0}};
  Point<HapticBase> hand{{0.0, 0.05, 0.0}};
  std::function<ports::SurfaceContact(const Point<HapticBase>&, double)> surface = device::BreathingPlane{};
  Person person = waits_at(0.05);
  std::function<void(control::ControlInput&, double)> spoil = [](control::ControlInput&, double) {};
  std::function<void(const control::ControlOutput&, double)> watch = [](const control::ControlOutput&, double) {};
};

/// The scene with no effects but these.
template <class... Effects>
ControllerScene with_only(const Effects&... effects) {
  ControllerScene scene;
  scene.settings.effects = {};
  (void)(scene.settings.effects.add(effects) && ...);
  return scene;
}

inline Felt feel(const ControllerScene& scene) {
  trials::VirtualStation station(scene.settings);
  station.place(scene.device, scene.hand);
  Felt felt;
  const auto ticks = static_cast<int>(scene.seconds / scene.settings.tick_s);
  for (int i = 0; i < ticks; ++i) {
    const double now_s = station.time_s();
    const device::SimulatedPair before = station.pair();
    const control::ControlOutput out =
        station.step(scene.surface, scene.person, [&](control::ControlInput& in) { scene.spoil(in, now_s); });
    felt.add(out, before, station.pair(), scene.settings.tick_s);
    scene.watch(out, now_s);
  }
  return felt;
}

}  // namespace telepalp::hard_cases
