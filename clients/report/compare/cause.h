#pragma once

#include <string>

#include "clients/report/compare/run.h"
#include "clients/report/compare/tick_comparison.h"

namespace telepalp::report {

/// "A is in the state “in body” and B in “released”"
[[nodiscard]] std::string states_in_words(const Run& a, const Run& b, const Instant& instant);

/// "the force is 1.2 N in A and 0.4 N in B, and the force vectors differ by 0.8 N"
[[nodiscard]] std::string forces_in_words(const Run& a, const Run& b, const Instant& instant);

/// The likely cause of a difference at `instant`, from what both stations published until then. It is the first of
/// these that is true: the hands are more than 1 mm apart; one station alone has let go (released or faulted), while
/// surface_age_ms() has a value for both runs or for neither; it has a value for one run only; its values differ by
/// more than 5 ms. If none is true, the text says so.
[[nodiscard]] std::string cause_in_words(const Run& a, const Run& b, const Instant& instant);

/// Age [ms] of the surface from which the force at `tick` was computed; NaN (kUnknown) if no state message lies within
/// 20 ms of the tick, or the station has no surface.
[[nodiscard]] double surface_age_ms(const Session& session, std::size_t tick);

}  // namespace telepalp::report
