#include "clients/report/compare/cause.h"

#include <cmath>

#include "clients/ar/messages/phases.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::readable;

constexpr double kHandsApart_m = 1e-3;  // more than a tracker's noise
constexpr double kAgesApart_ms = 5.0;   // more than the 10 ms grid of states rounds, on average
constexpr std::int64_t kNear_ns = 20'000'000;
constexpr std::int64_t kBefore_ns = 1'000'000'000;

double force_N(const Session& session, std::size_t tick) {
  const Axes& force = session.ticks.force;
  return std::hypot(double{force[0][tick]}, double{force[1][tick]}, double{force[2][tick]});
}

std::string phase_words(const Session& session, std::size_t tick) {
  return std::string(ar::words_for(session.ticks.phase[tick]).words);
}

bool has_let_go(const Session& session, std::size_t tick) {
  const msg::Phase phase = session.ticks.phase[tick];
  return phase == msg::PHASE_RELEASED || phase == msg::PHASE_FAULTED;
}

/// The newest event other than a change of state in the second before the tick; empty: none.
std::string last_event(const Session& session, std::size_t tick) {
  const std::int64_t now_ns = session.ticks.at_ns[tick];
  std::string text;
  for (const msg::StationEvent& event : session.events) {
    const auto at_ns = static_cast<std::int64_t>(event.stamp_ns());
    if (event.kind() != msg::EVENT_KIND_PHASE && at_ns <= now_ns && at_ns + kBefore_ns >= now_ns) text = event.text();
  }
  return text;
}

std::string letting_go(const Run& run, std::size_t tick, const char* name) {
  const std::string event = last_event(run.session, tick);
  return std::string(name) + " gives the hand no force (state: " + phase_words(run.session, tick) + ")" +
         (event.empty() ? "" : "; its last event: " + event);
}

std::string ages(double a_ms, double b_ms) {
  return "the surface that is touched is " + readable(a_ms) + " ms old in A and " + readable(b_ms) + " ms in B";
}

}  // namespace

double surface_age_ms(const Session& session, std::size_t tick) {
  const std::int64_t at_ns = session.ticks.at_ns[tick];
  const msg::StationState* best = nullptr;
  const auto apart = [&](const msg::StationState& state) {
    return std::abs(static_cast<std::int64_t>(state.stamp_ns()) - at_ns);
  };
  for (const msg::StationState& state : session.states)
    if (best == nullptr || apart(state) < apart(*best)) best = &state;
  if (best == nullptr || apart(*best) > kNear_ns || best->surface_captured_ns() == 0) return kUnknown;
  return 1e-6 * static_cast<double>(static_cast<std::int64_t>(best->stamp_ns() - best->surface_captured_ns()));
}

std::string states_in_words(const Run& a, const Run& b, const Instant& instant) {
  return "A is in the state “" + phase_words(a.session, instant.tick_a) + "” and B in “" +
         phase_words(b.session, instant.tick_b) + "”";
}

std::string forces_in_words(const Run& a, const Run& b, const Instant& instant) {
  return "the force is " + readable(force_N(a.session, instant.tick_a)) + " N in A and " +
         readable(force_N(b.session, instant.tick_b)) + " N in B, and the force vectors differ by " +
         readable(instant.force_apart_N) + " N";
}

std::string cause_in_words(const Run& a, const Run& b, const Instant& instant) {
  if (instant.hands_apart_m > kHandsApart_m)
    return "the hands of A and B are " + readable(1e3 * instant.hands_apart_m) +
           " mm apart: from this instant on they examine different places";
  const bool a_let_go = has_let_go(a.session, instant.tick_a), b_let_go = has_let_go(b.session, instant.tick_b);
  const double age_a = surface_age_ms(a.session, instant.tick_a), age_b = surface_age_ms(b.session, instant.tick_b);
  const bool ages_differ = std::abs(age_a - age_b) > kAgesApart_ms;
  if (a_let_go != b_let_go && std::isfinite(age_a) == std::isfinite(age_b))
    return letting_go(a_let_go ? a : b, a_let_go ? instant.tick_a : instant.tick_b, a_let_go ? "A" : "B") +
           (ages_differ ? "; " + ages(age_a, age_b) : "");
  if (std::isfinite(age_a) != std::isfinite(age_b))
    return std::string(std::isfinite(age_a) ? "B" : "A") +
           " has no surface from a depth image, or recorded no /station/state message within 20 ms of this instant";
  if (ages_differ) return ages(age_a, age_b);
  return "not known: the hands are at most 1 mm apart, and the ages of the surfaces differ by at most 5 ms or are "
         "unknown in both; compare the settings";
}

}  // namespace telepalp::report
