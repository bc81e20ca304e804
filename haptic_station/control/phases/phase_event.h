#pragma once

#include <optional>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/effects/effect.h"

namespace telepalp::control {

/// What a tick's inputs say, as far as the phases care.
struct Seen {
  bool fault_stands = false;   ///< a FaultCause stands at this tick
  bool fault_latched = false;  ///< a force was not finite
  bool rearm = false;          ///< an operator asks for it
  bool inputs_stale = false;   ///< tracker or surface older than its limit
  bool in_body = false;        ///< S1's i_b
  bool below_plane = false;    ///< the end-effector
  bool at_plane = false;       ///< the end-effector, at the height of S1 eq. (5)
  bool hand_rose = false;      ///< clearly above the plane and the end-effector
  effects::ObjectTouch touch = effects::ObjectTouch::None;
};

/// Pressing, near or away from an inner object.
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

/// The event that `seen` makes in this phase; nullopt: none. Safety first, then S1 Fig. 4. Where two could be, the
/// first counts: the other is asked for again at the next tick.
[[nodiscard]] constexpr std::optional<Event> event_in(Phase phase, const Seen& seen) noexcept {
  const auto when = [](bool condition, Event event) noexcept {
    return condition ? std::optional<Event>(event) : std::nullopt;
  };
  if (phase == Phase::Faulted) return when(seen.rearm && !seen.fault_stands, Event::Rearm);
  if (seen.fault_stands || seen.fault_latched) return Event::Fault;
  if (phase == Phase::Released) return when(!seen.inputs_stale, Event::InputsBack);
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
