#pragma once

#include <string>
#include <vector>

#include "clients/report/compare/comparison.h"

namespace telepalp::report {

/// The likely causes of the differences of two runs, the most likely first, each in one sentence without a full stop:
/// 1. settings that act on the force and differ (scene, depth coding, surface, camera, clock, network, hand, …);
/// 2. what the sessions lack or measured otherwise: ticks, images, depth;
/// 3. what the contacts show: a clipped force, a contact that begins deeper, another force at equal indentation;
/// 4. the state of both runs at the first difference that is felt: hands apart, a station that let go, another age;
/// 5. other settings that differ: source, software, computer.
/// Never empty: without any of these, one sentence says that the cause is not known.
[[nodiscard]] std::vector<std::string> causes_of(const Comparison& comparison);

/// "A is in the state “in body” and B in “released”"
[[nodiscard]] std::string states_in_words(const Run& a, const Run& b, const Instant& instant);

/// "the force is 1.2 N in A and 0.4 N in B, and the force vectors differ by 0.8 N"
[[nodiscard]] std::string forces_in_words(const Run& a, const Run& b, const Instant& instant);

/// What both stations published until `instant` says about the difference there. It is the first of these that is true:
/// the hands are more than 1 mm apart; one station alone has let go (released or faulted), while surface_age_ms() has a
/// value for both runs or for neither; it has a value for one run only; its values differ by more than 5 ms. If none is
/// true: empty.
[[nodiscard]] std::string cause_in_words(const Run& a, const Run& b, const Instant& instant);

/// Age [ms] of the surface from which the force at `tick` was computed; NaN (kUnknown) if no state message lies within
/// 20 ms of the tick, or the station has no surface.
[[nodiscard]] double surface_age_ms(const Session& session, std::size_t tick);

}  // namespace telepalp::report
