#pragma once

#include <string>

#include "support/program/log.h"

namespace telepalp::station {

/// Writes a line to the station's log.
inline void say(const std::string& text) { program::log("telepalp-station", text); }

}  // namespace telepalp::station
