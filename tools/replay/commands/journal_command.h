#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Computes a station's journal (Request::journal) again, prints whether force, phase and proxy of each tick equal
/// those in the journal as doubles, and writes both forces to Request::out, if that is given. Returns true if all are
/// equal. Error: the file is no journal, or its scene cannot be made.
[[nodiscard]] Result<bool> run_journal(const Request& request);

}  // namespace telepalp::replay
