#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

namespace telepalp::loop {

/// The record of one tick of the 2 kHz loop. Positions [m] and forces [N] are in the haptic base's frame H; members
/// whose names end in `camera` are in the depth camera's frame K. The haptic thread hands the record to the network
/// thread by copy.
struct TickSample {
  std::uint64_t tick = 0;         ///< number since start
  std::int64_t stamp_ns = 0;      ///< session time of the tick's deadline
  std::uint32_t late_ns = 0;      ///< delay from the deadline to the wake-up
  float work_us = 0.0F;           ///< computing time of the tick; the sending of the force is not included
  std::uint8_t phase = 0;         ///< control::Phase, as in msg.Phase
  std::uint8_t fault = 0;         ///< control::FaultCause that led to the phase Faulted
  std::uint8_t fault_stands = 0;  ///< control::FaultCause that persists and blocks re-arming
  bool in_body = false;
  bool contact_unknown = false;      ///< no contact can be computed: the surface is stale or not near the device
  bool limited = false;              ///< limiter, relaxed springs (spring.h) or a gradual release changed the force
  bool object_unseen = false;        ///< an object inside the body stays where it is: the skin above it is not seen
  bool object_slide_unseen = false;  ///< the skin's tangential motion (slide) above an object cannot be measured
  bool gives_torque = false;         ///< the device states that it gives torques
  bool indexing = false;             ///< the hand is beyond the touch cylinder, so the body gives no force
  std::array<float, 3> workspace_shift{};  ///< position in H minus position in the device's own frame
  std::array<float, 3> hand{};
  std::array<float, 3> device{};
  std::array<float, 3> proxy{};
  std::array<float, 3> normal{};
  std::array<float, 3> force{};
  std::array<float, 3> displayed_hand_camera{};
  std::array<float, 4> hand_attitude_camera{};  ///< x, y, z, w of the hand's axes in K; all zero: not known
  std::array<float, 3> proxy_camera{};
  std::array<float, 3> normal_camera{};
  std::array<float, 3> device_camera{};
  std::array<float, 3> force_camera{};
  std::array<float, 3> torque{};                ///< on the hand, about the device point [N m]
  std::array<float, 3> torque_camera{};         ///< the same in K
  std::array<float, 4> tool_attitude_camera{};  ///< x, y, z, w of the tool's axes in K; all zero: not measured
  float indentation_m = 0.0F;  ///< |d| of paper S1 eq. (8) (docs/sources.md), depth in the skin; 0 out of contact
  float distance_m = 0.0F;     ///< signed distance of the device point from the skin; negative inside
  float passivity_J = 0.0F;    ///< energy taken from the hand minus stored energy; negative: the display is active
  float hand_excess_J = 0.0F;  ///< work on the hand in this contact minus the measured skin's work on the same path
  float unmodelled = 0.0F;     ///< 1: the skin moves unusually fast, or the camera was pushed; then falls to 0 in 1 s
  float yields_in_s = 0.0F;    ///< time until the motors' heat lowers the contact force; infinite: never
  float device_age_s = 0.0F;   ///< this and the next two: ages of the inputs of the controller at this tick
  float hand_age_s = 0.0F;
  float surface_age_s = 0.0F;
  std::int64_t surface_captured_ns = 0;
  std::int64_t hand_sampled_ns = 0;
};
static_assert(std::is_trivially_copyable_v<TickSample>);

}  // namespace telepalp::loop
