#include "haptic_station/control/parts/phase_machine.h"

namespace telepalp::control {

std::optional<Event> PhaseMachine::step(const Seen& seen, FaultCause stands, double dt_s) noexcept {
  previous_ = phase_;
  in_phase_s_ += dt_s;
  // Released lasts until the inputs have been good for the whole dwell: an age that swings about its limit cannot make
  // the station let go and come back in a loop.
  if (phase_ == Phase::Released && seen.inputs_stale) in_phase_s_ = 0.0;
  const std::optional<Event> event = event_in(phase_, seen);
  if (!event) return std::nullopt;
  const Row* row = transition(phase_, *event);
  if (row == nullptr || (row->waits_for_dwell && in_phase_s_ < dwell_s_)) return std::nullopt;
  // Without a standing cause the limiter's latch made the event: a force was not finite.
  if (*event == Event::Fault) fault_ = stands != FaultCause::None ? stands : FaultCause::NotFinite;
  if (*event == Event::Rearm) fault_ = FaultCause::None;
  enter(row->to);
  return event;
}

/// The dwell in the body counts the phases at inner objects as one stay.
void PhaseMachine::enter(Phase phase) noexcept {
  if (!(is_inside(phase) && is_inside(phase_))) in_phase_s_ = 0.0;
  phase_ = phase;
}

}  // namespace telepalp::control
