#pragma once

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

/// True when all numbers of `in` are finite. `hand` and `contact` count only while they are valid, and
/// `contact.anchor_velocity` only while the anchor is seen. Not checked: the ages of tracker and surface, because an
/// age that is NaN counts as too old.
[[nodiscard]] bool is_finite(const ControlInput& in) noexcept;

/// An input without a hand or a surface, with the end-effector at `device`. It replaces an input that is not finite, so
/// that no NaN reaches the controller's state. It copies only the re-arm request from `in`.
[[nodiscard]] ControlInput blank_input(const ControlInput& in, const Point<HapticBase>& device) noexcept;

/// The reason why the station must fault at this tick, or FaultCause::None. While the hand is `touching` the skin, the
/// force does not depend on the tracker, so implausible tracker samples are then no fault: HandEstimate drops them, and
/// the age of its newest sample grows until hand_is_lost().
[[nodiscard]] FaultCause standing_fault(const ControlInput& in, bool touching, const AgeLimits& ages) noexcept;

/// True when the surface is older than its limit. An age that is NaN counts as too old.
[[nodiscard]] bool surface_is_stale(const ControlInput& in, const AgeLimits& ages) noexcept;

/// True when the device's readings have not been finite for longer than the limit. The station then releases the hand,
/// and resumes once readings are finite.
[[nodiscard]] bool device_is_unreadable(const ControlInput& in, const AgeLimits& ages) noexcept;

/// True when the tracker has not seen the hand within `limit_s`. An age that is NaN counts as too old, and so does a
/// sample more than `limit_s` in the future.
[[nodiscard]] bool hand_is_lost(const ControlInput& in, double limit_s) noexcept;

}  // namespace telepalp::control
