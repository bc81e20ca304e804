#include "haptic_station/control/phases/phase.h"

#include "proto/words/phase_names.h"

namespace telepalp::control {
namespace {

using P = Phase;
using E = Event;

/// S1 Fig. 4. The dwell applies on the way out of the body. There a delay is harmless, and the dwell prevents rapid
/// changes of phase. Contact never waits for the dwell, because a fast hand would pass through the skin before it felt
/// it: In body begins on the tick at which the hand meets the skin, from each phase outside. In Released, this needs a
/// hand that was seen outside the skin since the inputs became valid. A hand that is already in the body waits for the
/// dwell, so that inputs that come and go do not make the force come and go. Transitions at inner objects ("simply
/// dependent on the hand position") and releases never wait.
constexpr Row kTransitions[] = {
    {P::InBody, E::FromBody, P::BodyToPlane, true},
    {P::InBody, E::NearObject, P::AroundObject, false},
    {P::InBody, E::TouchUpper, P::ObjectUpper, false},
    {P::InBody, E::TouchLateral, P::ObjectLateral, false},
    {P::BodyToPlane, E::ToPlane, P::OutBody, true},
    {P::BodyToPlane, E::IntoBody, P::InBody, false},
    {P::OutBody, E::UnderPlane, P::PlaneToBody, true},
    {P::OutBody, E::IntoBody, P::InBody, false},
    {P::PlaneToBody, E::IntoBody, P::InBody, false},
    {P::PlaneToBody, E::HandRose, P::BodyToPlane, true},
    {P::AroundObject, E::AwayFromObject, P::InBody, false},
    {P::AroundObject, E::TouchUpper, P::ObjectUpper, false},
    {P::AroundObject, E::TouchLateral, P::ObjectLateral, false},
    {P::AroundObject, E::FromBody, P::BodyToPlane, true},
    {P::ObjectUpper, E::NearObject, P::AroundObject, false},
    {P::ObjectUpper, E::AwayFromObject, P::InBody, false},
    {P::ObjectUpper, E::TouchLateral, P::ObjectLateral, false},
    {P::ObjectUpper, E::FromBody, P::BodyToPlane, true},
    {P::ObjectLateral, E::NearObject, P::AroundObject, false},
    {P::ObjectLateral, E::AwayFromObject, P::InBody, false},
    {P::ObjectLateral, E::TouchUpper, P::ObjectUpper, false},
    {P::ObjectLateral, E::FromBody, P::BodyToPlane, true},
    {P::InBody, E::InputStale, P::Released, false},
    {P::BodyToPlane, E::InputStale, P::Released, false},
    {P::OutBody, E::InputStale, P::Released, false},
    {P::PlaneToBody, E::InputStale, P::Released, false},
    {P::AroundObject, E::InputStale, P::Released, false},
    {P::ObjectUpper, E::InputStale, P::Released, false},
    {P::ObjectLateral, E::InputStale, P::Released, false},
    {P::Released, E::IntoBody, P::InBody, false},
    {P::Released, E::InputsBack, P::BodyToPlane, true},
    {P::InBody, E::Fault, P::Faulted, false},
    {P::BodyToPlane, E::Fault, P::Faulted, false},
    {P::OutBody, E::Fault, P::Faulted, false},
    {P::PlaneToBody, E::Fault, P::Faulted, false},
    {P::AroundObject, E::Fault, P::Faulted, false},
    {P::ObjectUpper, E::Fault, P::Faulted, false},
    {P::ObjectLateral, E::Fault, P::Faulted, false},
    {P::Released, E::Fault, P::Faulted, false},
    {P::Faulted, E::Rearm, P::Released, false},
};

}  // namespace

std::span<const Row> transitions() noexcept { return kTransitions; }

const Row* transition(Phase phase, Event event) noexcept {
  for (const Row& row : kTransitions)
    if (row.from == phase && row.on == event) return &row;
  return nullptr;
}

const char* name(Phase phase) noexcept { return phase_name(static_cast<int>(phase)).in_S1.data(); }

const char* name(Event event) noexcept {
  switch (event) {
    case E::FromBody:
      return "FromBody";
    case E::ToPlane:
      return "ToPlane";
    case E::UnderPlane:
      return "UnderPlane";
    case E::HandRose:
      return "HandRose";
    case E::IntoBody:
      return "IntoBody";
    case E::NearObject:
      return "NearObject";
    case E::AwayFromObject:
      return "AwayFromObject";
    case E::TouchUpper:
      return "TouchUpper";
    case E::TouchLateral:
      return "TouchLateral";
    case E::InputStale:
      return "InputStale";
    case E::InputsBack:
      return "InputsBack";
    case E::Fault:
      return "Fault";
    case E::Rearm:
      return "Rearm";
  }
  return "?";
}

const char* name(FaultCause cause) noexcept {
  switch (cause) {
    case FaultCause::None:
      return "no fault";
    case FaultCause::DeviceSilent:
      return "the haptic device is silent: it sends no positions, or its motors are off";
    case FaultCause::NotFinite:
      return "a position, speed, force or age of a measurement is not a finite number";
    case FaultCause::DeviceImplausible:
      return "the haptic device reports impossibly fast movements";
    case FaultCause::HandImplausible:
      return "the hand tracker reports impossibly fast movements";
  }
  return "?";
}

int plotted_number(Phase phase) noexcept {
  constexpr std::array<int, kPhaseCount> kNumbers = {0, 1, 2, 3, -1, -2, -3, 4, 5};
  return kNumbers[static_cast<std::size_t>(phase) - 1];
}

}  // namespace telepalp::control
