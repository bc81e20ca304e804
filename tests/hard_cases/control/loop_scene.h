#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/loop/plane_snapshot.h"
#include "tests/hard_cases/control/felt.h"
#include "tests/hard_cases/control/people.h"

namespace telepalp::hard_cases {

/// What a camera saw: a level skin.
struct SeenPlane {
  double captured_s = 0.0;
  double height_m = 0.0;
};

inline effects::EffectBank the_skin(const effects::Skin::Settings& settings = {}) {
  effects::EffectBank skin;
  (void)skin.add(effects::Skin(settings));
  return skin;
}

struct TrackedHand {
  double at_s = 0.0;
  Point<HapticBase> hand;
};

/// The live loop's tick in virtual time, from stamped hand samples and surfaces to the force, for data that comes late,
/// twice, from the future or not at all. The hooks are called at each tick. Defaults: an exact camera at 30 Hz and an
/// exact tracker at 100 Hz, both without delay; the only effect is the skin.
struct LoopScene {
  static constexpr double kTick_s = 0.0005;
  static constexpr int kTicksPerFrame = 67;
  static constexpr int kTicksPerSample = 20;

  double seconds = 5.0;
  effects::EffectBank effects = the_skin();
  control::ControlSettings control{};
  Person person = presses_to(0.03);
  /// The output of camera and tracker at tick `tick`, at the time `now_s`.
  std::function<std::optional<SeenPlane>(int tick, double now_s)> camera = [](int tick, double now_s) {
    return tick % kTicksPerFrame == 0 ? std::optional(SeenPlane{now_s}) : std::nullopt;
  };
  std::function<std::vector<TrackedHand>(int tick, double now_s, const Point<HapticBase>& hand)> tracker =
      [](int tick, double now_s, const Point<HapticBase>& hand) {
        return tick % kTicksPerSample == 0 ? std::vector<TrackedHand>{{now_s, hand}} : std::vector<TrackedHand>{};
      };
  /// Replaces the true reading of the device's encoders at `now_s`.
  std::function<void(double now_s, ports::DeviceReading&)> encoders = [](double, ports::DeviceReading&) {};
  /// Whether an operator asks to re-arm at `now_s`.
  std::function<bool(double now_s)> rearms = [](double) { return false; };
  std::function<void(const loop::TickOut&, double now_s, const loop::HapticLoop&, const device::SimulatedPair&)> watch =
      [](const loop::TickOut&, double, const loop::HapticLoop&, const device::SimulatedPair&) {};
};

inline SessionTime at_s(double seconds) { return session_time(4'000'000'000'000) + from_seconds(seconds); }

/// The tick at `now_s` of a loop whose device and hand are `pair`, with a reading and nothing else.
inline loop::TickIn in_of(const device::SimulatedPair& pair, double now_s) {
  return {.now = at_s(now_s),
          .dt_s = LoopScene::kTick_s,
          .reading = {.at = pair.device(), .velocity = pair.device_velocity()}};
}

/// The surface that the loop touches, and the one before it, to which the loop refers until the next tick.
class ShownSurface {
 public:
  [[nodiscard]] const loop::TouchableSurface* show(loop::TouchableSurface newer) {
    before_ = std::exchange(shown_, std::move(newer));
    return &shown_;
  }

 private:
  loop::TouchableSurface shown_;
  loop::TouchableSurface before_;
};

inline Felt feel(const LoopScene& scene) {
  loop::HapticLoop loop({}, control::EncounteredController(scene.control, scene.effects));
  device::SimulatedPair pair({}, {});
  pair.place({{0.0, 0.05, 0.0}}, {{0.0, 0.06, 0.0}});
  ShownSurface shown;
  std::deque<TrackedHand> tracked;  // the station's trackers give one sample per tick
  Felt felt;
  for (int tick = 0; tick * LoopScene::kTick_s < scene.seconds; ++tick) {
    const double now_s = tick * LoopScene::kTick_s;
    loop::TickIn in = in_of(pair, now_s);
    in.rearm = scene.rearms(now_s);
    if (const auto seen = scene.camera(tick, now_s)) {
      auto newer = std::make_shared<loop::PlaneSnapshot>(Eigen::Vector3d::UnitY() * seen->height_m,
                                                         Eigen::Vector3d::UnitY(), 1.0);
      newer->captured = at_s(seen->captured_s);
      in.surface = shown.show({std::move(newer), {}});
    }
    for (const TrackedHand& one : scene.tracker(tick, now_s, pair.true_hand())) tracked.push_back(one);
    if (!tracked.empty()) {
      in.hand = {at_s(tracked.front().at_s), tracked.front().hand};
      tracked.pop_front();
    }
    scene.encoders(now_s, in.reading);
    const loop::TickOut act = loop.tick(in);
    const device::SimulatedPair before = pair;
    pair.step(act.force, scene.person({now_s, act.contact, pair.device()}), LoopScene::kTick_s);
    felt.add(act.control, before, pair, LoopScene::kTick_s);
    scene.watch(act, now_s, loop, pair);
  }
  return felt;
}

}  // namespace telepalp::hard_cases
