#pragma once

#include <functional>
#include <optional>

#include "tools/replay/storm/invariants.h"
#include "tools/replay/storm/storm_case.h"

namespace telepalp::replay {

/// Changes each tick before it is checked. Only tests use it, to plant a defect.
using Spoil = std::function<void(TickRecord&)>;

/// The outcome of one case.
struct StormOutcome {
  std::optional<Invariants::Violation> violation;
  Invariants::Ledgers ledgers{};
  double seconds = 0.0;  ///< of session time
};

/// Runs a case and checks the invariants at every tick. Error: the patient or the scene cannot be read.
[[nodiscard]] Result<StormOutcome> run_case(const StormCase& storm, const Spoil& spoil = {});

/// Shortens a failing case to its violation, and replaces it by simpler cases as long as they fail.
[[nodiscard]] Result<StormCase> shrunk(StormCase failing, const Spoil& spoil = {});

}  // namespace telepalp::replay
