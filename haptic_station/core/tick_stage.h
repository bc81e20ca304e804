#pragma once

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/loop/compensation.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/loop/rig_tick.h"

namespace telepalp::core {

/// The station's tick as its simulations drive it: the haptic loop with a scene's controller, at a rig of any kind.
/// Runs in the tick of its driver, which gives time, surface and rig. Owner: one thread.
class TickStage {
 public:
  using Settings = loop::HapticLoop::Settings;

  TickStage(const control::ControlSettings& control, const effects::EffectBank& effects,
            const Settings& settings = {}) noexcept
      : loop_(settings, {control, effects}) {}

  /// One tick at `rig`: sample, decide, apply. `due`, `sampled` and `decided`: as for loop::tick_at_rig().
  template <class Sampled, class Decided>
  loop::TickOut run(ports::Rig& rig, const loop::TickIn& due, const Sampled& sampled, const Decided& decided) noexcept {
    return loop::tick_at_rig(loop_, rig, due, sampled, decided);
  }
  loop::TickOut run(ports::Rig& rig, const loop::TickIn& due) noexcept {
    return run(
        rig, due, [](const loop::TickIn&) {}, [](const loop::TickIn&, const loop::TickOut&) {});
  }

  /// A position from the device's own frame in H, with the last tick's shift.
  [[nodiscard]] Point<HapticBase> in_patient_frame(const Point<HapticBase>& at) const noexcept {
    return loop_.in_patient_frame(at);
  }
  [[nodiscard]] loop::Compensation compensation() const noexcept { return loop_.compensation(); }
  [[nodiscard]] loop::ObjectPlacements objects() const noexcept { return loop_.objects(); }
  [[nodiscard]] const effects::EffectBank& effects() const noexcept { return loop_.controller().effects(); }
  /// For JournalReplay, whose ticks need no rig.
  [[nodiscard]] loop::HapticLoop& loop() noexcept { return loop_; }

 private:
  loop::HapticLoop loop_;
};

}  // namespace telepalp::core
