#pragma once

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

/// True when every number that the controller would use is finite.
[[nodiscard]] bool is_finite(const ControlInput& in) noexcept;

/// An input without a hand and without a surface, with the end-effector at `device`: stands in for an input that is not
/// finite, so that no NaN reaches the controller's state. Only the operator's request is kept.
[[nodiscard]] ControlInput blank_input(const ControlInput& in, const Point<HapticBase>& device) noexcept;

/// Why the station must fault at this very tick, if it must.
[[nodiscard]] FaultCause standing_fault(const ControlInput& in, const AgeLimits& ages) noexcept;

/// True when the surface is older than its limit. An age that is NaN counts as too old.
[[nodiscard]] bool surface_is_stale(const ControlInput& in, const AgeLimits& ages) noexcept;

/// True when the tracker has not seen the hand within `limit_s`. An age that is NaN counts as too old, and so does a
/// sample from the future, which would never age.
[[nodiscard]] bool hand_is_lost(const ControlInput& in, double limit_s) noexcept;

}  // namespace telepalp::control
