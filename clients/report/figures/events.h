#pragma once

#include <string>

#include "clients/report/session/session.h"

namespace telepalp::report {

/// The section of the page with the station's events. Changes of phase, of which a minute of palpation has hundreds,
/// are folded; the page unfolds them without a script. Empty without events.
[[nodiscard]] std::string events_section(const Session& session);

}  // namespace telepalp::report
