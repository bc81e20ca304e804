#include "haptic_station/control/parts/phase_machine.h"

namespace telepalp::control {

std::optional<Event> PhaseMachine::step(const Seen& given, FaultCause stands, double dt_s) noexcept {
  previous_ = phase_;
  in_phase_s_ += dt_s;
  // Released lasts until the inputs have been valid for the whole dwell. Otherwise an age that oscillates around its
  // limit would make the station release and resume again and again.
  if (phase_ == Phase::Released && given.inputs_stale) in_phase_s_ = 0.0;
  was_outside_ = phase_ == Phase::Released ? was_outside_ || (given.outside && !given.inputs_stale)
                                           : given.outside && !has_let_go(phase_);
  Seen seen = given;
  seen.was_outside = was_outside_;
  const std::optional<Event> event = event_in(phase_, seen);
  if (!event) return std::nullopt;
  const Row* row = transition(phase_, *event);
  if (row == nullptr || (row->waits_for_dwell && in_phase_s_ < dwell_s_)) return std::nullopt;
  // Without another cause, the limiter has latched a force that was not finite.
  if (*event == Event::Fault) fault_ = stands != FaultCause::None ? stands : FaultCause::NotFinite;
  if (*event == Event::Rearm) fault_ = FaultCause::None;
  enter(row->to);
  return event;
}

/// In body and the phases at inner objects count as one phase for the dwell.
void PhaseMachine::enter(Phase phase) noexcept {
  if (!(is_inside(phase) && is_inside(phase_))) in_phase_s_ = 0.0;
  phase_ = phase;
}

}  // namespace telepalp::control
