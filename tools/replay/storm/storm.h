#pragma once

#include <functional>
#include <optional>

#include "tools/replay/storm/invariants.h"
#include "tools/replay/storm/storm_case.h"

namespace telepalp::replay {

/// Changes each tick before the invariants are checked. Only tests pass a Spoil, to plant a defect.
using Spoil = std::function<void(TickRecord&)>;

/// The outcome of one case.
struct StormOutcome {
  std::optional<Invariants::Violation> violation;
  Invariants::Ledgers ledgers{};
  double seconds = 0.0;  ///< of session time
};

/// Runs a case and checks the invariants at every tick. Error: the patient or the scene cannot be read.
[[nodiscard]] Result<StormOutcome> run_case(const StormCase& storm, const Spoil& spoil = {});

/// Ends a failing case soon after its violation, and applies each Simplification with which the case still fails.
[[nodiscard]] Result<StormCase> shrunk(StormCase failing, const Spoil& spoil = {});

}  // namespace telepalp::replay
