#pragma once

#include <string>
#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// The lanes in which somebody speaks, one chart for each side whose speech was recorded, on the time axis of the whole
/// session. The height of a bar is the loudest level in it. Empty without recorded speech.
[[nodiscard]] std::vector<plot::Chart> speech_lanes(const Session& session);

/// How long each side spoke, as sentences; empty without recorded speech.
[[nodiscard]] std::string speech_words(const Session& session);

}  // namespace telepalp::report
