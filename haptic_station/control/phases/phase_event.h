#pragma once

#include <optional>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/effects/effect.h"

namespace telepalp::control {

/// The facts of one tick that can change the phase.
struct Seen {
  bool fault_stands = false;   ///< a cause of a fault is present at this tick
  bool fault_latched = false;  ///< the limiter has latched a force that was not finite
  bool rearm = false;          ///< an operator asks to re-arm
  bool inputs_stale = false;   ///< tracker or surface older than its limit
  bool in_body = false;        ///< the device point is in the body: i_b of paper S1 (docs/sources.md)
  bool outside = false;        ///< the surface at the device point is known, and the device point is not in the body
  bool was_outside = false;    ///< set by PhaseMachine: in Released, the device point came from outside the body
  bool below_plane = false;    ///< the end-effector is below the plane
  bool at_plane = false;       ///< the end-effector is at or above the target height of S1 eq. (5)
  bool hand_rose = false;      ///< the hand is over hand_rose_m (TransitionSettings) above both plane and end-effector
  effects::ObjectTouch touch = effects::ObjectTouch::None;
};

/// The event that reports how the device point touches the inner objects: pressing one, near one, or away from all.
[[nodiscard]] constexpr Event object_event(effects::ObjectTouch touch) noexcept {
  switch (touch) {
    case effects::ObjectTouch::None:
      return Event::AwayFromObject;
    case effects::ObjectTouch::Near:
      return Event::NearObject;
    case effects::ObjectTouch::Lateral:
      return Event::TouchLateral;
    case effects::ObjectTouch::Upper:
      return Event::TouchUpper;
  }
  return Event::AwayFromObject;
}

/// The event that `seen` triggers in this phase; nullopt: no event. Safety events have priority over those of S1 Fig.
/// 4. If several events are possible, the first in the order of the tests below is returned; the next tick tests again.
[[nodiscard]] constexpr std::optional<Event> event_in(Phase phase, const Seen& seen) noexcept {
  const auto when = [](bool condition, Event event) noexcept {
    return condition ? std::optional<Event>(event) : std::nullopt;
  };
  if (phase == Phase::Faulted) return when(seen.rearm && !seen.fault_stands, Event::Rearm);
  if (seen.fault_stands || seen.fault_latched) return Event::Fault;
  if (phase == Phase::Released && seen.inputs_stale) return std::nullopt;
  if (phase == Phase::Released) return seen.in_body && seen.was_outside ? Event::IntoBody : Event::InputsBack;
  if (seen.inputs_stale) return Event::InputStale;
  if (is_inside(phase)) {
    if (seen.in_body) return object_event(seen.touch);
    return Event::FromBody;
  }
  if (seen.in_body) return Event::IntoBody;
  if (phase == Phase::OutBody) return when(seen.below_plane, Event::UnderPlane);
  if (phase == Phase::BodyToPlane) return when(seen.at_plane, Event::ToPlane);
  return when(seen.hand_rose, Event::HandRose);
}

}  // namespace telepalp::control
