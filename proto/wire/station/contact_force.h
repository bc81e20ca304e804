#pragma once

#include "messages/station.pb.h"

namespace telepalp::wire {

/// True in the phases in which the skin, or an object below it, gives the device's force. In all other phases the force
/// is the drive's: it moves the free device above the body, or fades after the station has let go. Everything that
/// shows a force asks one of these two functions whether to show it as a force of contact or as the drive's.
[[nodiscard]] constexpr bool is_contact(msg::Phase phase) noexcept {
  return phase == msg::PHASE_IN_BODY || phase == msg::PHASE_CYLINDER_LATERAL || phase == msg::PHASE_AROUND_CYLINDER ||
         phase == msg::PHASE_CYLINDER_UPPER;
}

/// The same for a state. Beyond the cylinder of workspace indexing (`indexing`), the force is the drive's in each
/// phase.
[[nodiscard]] inline bool is_contact(const msg::StationState& state) noexcept {
  return is_contact(state.phase()) && !state.indexing();
}

}  // namespace telepalp::wire
