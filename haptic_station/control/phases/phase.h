#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace telepalp::control {

/// The phases of Fig. 4 of paper S1 (docs/sources.md), and two phases without force that S1 does not have. The values
/// are those of telepalp.msg.Phase. The numbers in parentheses are the values of S1's state variable s_f.
enum class Phase : std::uint8_t {
  InBody = 1,         ///< force control: the hand feels the skin (0)
  BodyToPlane = 2,    ///< a gentle lift carries the end-effector away from the body (1)
  OutBody = 3,        ///< position control on the plane above the body, following the free hand (2)
  PlaneToBody = 4,    ///< neither force nor position control: the hand can push the end-effector to the body (3)
  ObjectLateral = 5,  ///< in the body, pressing an inner object's side (-1)
  AroundObject = 6,   ///< in the body, beside an inner object (-2)
  ObjectUpper = 7,    ///< in the body, pressing an inner object's upper face (-3)
  Released = 8,       ///< no force until tracker and surface have been valid for the dwell time, or the hand has met
                      ///< the skin from outside while they were valid
  Faulted = 9,        ///< no force until an operator re-arms; then Released
};

enum class Event : std::uint8_t {
  FromBody,    ///< the device point has left the body, however little: S1's i_b becomes false
  ToPlane,     ///< S1: the end-effector has reached its target height, just above the waiting plane
  UnderPlane,  ///< S1: the hand has pushed the end-effector below the plane
  HandRose,    ///< the hand left the waiting end-effector and is above the plane
  IntoBody,    ///< the device point has entered the body: S1's i_b becomes true
  NearObject,  ///< the device point is within an inner object's margin
  AwayFromObject,
  TouchUpper,    ///< pressing an inner object, its upper face nearest
  TouchLateral,  ///< pressing an inner object, its side nearest
  InputStale,    ///< tracker or surface older than its limit
  InputsBack,    ///< tracker and surface are within their age limits again
  Fault,         ///< a FaultCause is present, or the limiter has latched a force that was not finite
  Rearm,         ///< an operator re-arms
};

/// Why the station must not give force.
enum class FaultCause : std::uint8_t {
  None,
  DeviceSilent,       ///< the last reading of the device is older than its limit
  NotFinite,          ///< a number in the input or in the force is NaN or infinite
  DeviceImplausible,  ///< the device reports impossibly fast movements for longer than AgeLimits::implausible_s
  /// While the device does not touch the body, the hand tracker reports impossibly fast movements for longer than
  /// AgeLimits::hand_implausible_s.
  HandImplausible,
};

struct Row {
  Phase from;
  Event on;
  Phase to;
  bool waits_for_dwell;  ///< the transition waits until `from` has lasted the dwell time, 0.3 s in S1
};

inline constexpr std::size_t kPhaseCount = 9;
inline constexpr std::size_t kEventCount = 13;
[[nodiscard]] std::span<const Row> transitions() noexcept;

/// The row of the transition table for `phase` and `event`; nullptr: the event does not change this phase.
[[nodiscard]] const Row* transition(Phase phase, Event event) noexcept;

/// True for In body and the three phases at an inner object.
[[nodiscard]] constexpr bool is_inside(Phase phase) noexcept {
  return phase == Phase::InBody || phase == Phase::ObjectLateral || phase == Phase::AroundObject ||
         phase == Phase::ObjectUpper;
}
[[nodiscard]] constexpr bool has_let_go(Phase phase) noexcept {
  return phase == Phase::Released || phase == Phase::Faulted;
}

/// The phase's name, as in S1.
[[nodiscard]] const char* name(Phase phase) noexcept;
[[nodiscard]] const char* name(Event event) noexcept;
[[nodiscard]] const char* name(FaultCause cause) noexcept;

/// The number s_f that S1's figures plot; 4 and 5 for Released and Faulted, which S1 does not have.
[[nodiscard]] int plotted_number(Phase phase) noexcept;

}  // namespace telepalp::control
