#pragma once

#include <string>

#include "support/program/log.h"

namespace telepalp::replay {

/// Writes a line to the log of telepalp-replay.
inline void say(const std::string& text) { program::log("telepalp-replay", text); }

}  // namespace telepalp::replay
