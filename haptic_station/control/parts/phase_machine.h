#pragma once

#include <optional>

#include "haptic_station/control/phases/phase_event.h"

namespace telepalp::control {

/// Holds the phase, its duration and the cause of a fault; applies the transition table of phase.h. For the dwell, In
/// body and the phases at inner objects count as one, and Released counts from valid inputs. Owner: haptic thread.
class PhaseMachine {
 public:
  /// `dwell_s`: the dwell time, 0.3 s in paper S1 (docs/sources.md).
  explicit PhaseMachine(double dwell_s) noexcept : dwell_s_(dwell_s) {}

  /// Computes one tick, `dt_s` after the last. `given.was_outside` is not used. `stands`: the fault cause that is
  /// present now. Returns the event that changed the phase, or nullopt if the phase stays.
  std::optional<Event> step(const Seen& given, FaultCause stands, double dt_s) noexcept;

  [[nodiscard]] Phase phase() const noexcept { return phase_; }
  [[nodiscard]] Phase previous() const noexcept { return previous_; }  ///< the phase of the tick before
  [[nodiscard]] FaultCause fault() const noexcept { return fault_; }

  /// True when the phase changed at this tick. Changes between In body and the phases at an inner object do not count.
  [[nodiscard]] bool outer_change() const noexcept {
    return phase_ != previous_ && !(is_inside(phase_) && is_inside(previous_));
  }

 private:
  void enter(Phase phase) noexcept;

  double dwell_s_;
  Phase phase_ = Phase::Released;
  Phase previous_ = Phase::Released;
  FaultCause fault_ = FaultCause::None;
  double in_phase_s_ = 0.0;
  bool was_outside_ = false;  ///< in Released: `Seen::outside` was true at the release, or later with valid inputs
};

}  // namespace telepalp::control
