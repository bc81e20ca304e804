#pragma once

#include <string>

#include "clients/report/compare/run.h"
#include "clients/report/compare/tick_comparison.h"

namespace telepalp::report {

/// "A is in the state “in body” and B in “released”"
[[nodiscard]] std::string states_in_words(const Run& a, const Run& b, const Instant& instant);

/// "the force is 1.2 N in A and 0.4 N in B, 0.8 N apart as vectors"
[[nodiscard]] std::string forces_in_words(const Run& a, const Run& b, const Instant& instant);

/// The likely cause of a difference at `instant`, from what both stations published until then, in this order: a hand
/// that moved differently, a surface that is missing or of another age, a station that let go. Otherwise says that
/// neither explains it.
[[nodiscard]] std::string cause_in_words(const Run& a, const Run& b, const Instant& instant);

/// Age at the tick of the surface that made the force [ms]; kUnknown without a state near the tick or a surface.
[[nodiscard]] double surface_age_ms(const Session& session, std::size_t tick);

}  // namespace telepalp::report
