#include "clients/report/compare/tick_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "proto/wire/station/contact_force.h"

namespace telepalp::report {
namespace {

double distance(const Axes& a, std::size_t at_a, const Axes& b, std::size_t at_b) {
  return std::hypot(double{a[0][at_a]} - double{b[0][at_b]}, double{a[1][at_a]} - double{b[1][at_b]},
                    double{a[2][at_a]} - double{b[2][at_b]});
}

std::int64_t beginning(const Session& session) noexcept {
  return session.ticks.size() > 0 ? session.ticks.at_ns.front() : session.first_ns.value_or(0);
}

/// Index of the tick of `ticks` that is nearest to `at_ns`, searched from `from` on; times ascend.
std::size_t nearest_tick(const Ticks& ticks, std::int64_t at_ns, std::size_t from) {
  while (from + 1 < ticks.size() && std::abs(ticks.at_ns[from + 1] - at_ns) <= std::abs(ticks.at_ns[from] - at_ns))
    ++from;
  return from;
}

void take(TickComparison& result, const Instant& now, msg::Phase a, msg::Phase b) {
  const double apart_N = std::isfinite(now.force_apart_N) ? now.force_apart_N : std::numeric_limits<double>::infinity();
  ++result.common;
  if (a != b) ++result.phase_other;
  if (a != b && !result.first_phase) result.first_phase = now;
  const bool contact = wire::is_contact(a) || wire::is_contact(b);
  if (contact && apart_N > kFelt_N && !result.first_felt) result.first_felt = now;
  if (apart_N > (result.largest ? result.largest->force_apart_N : 0.0)) result.largest = now;
  result.at_s.push_back(now.at_s);
  result.apart_N.push_back(now.force_apart_N);
}

}  // namespace

bool share_time(const Session& a, const Session& b) noexcept {
  return a.first_ns && b.first_ns && *a.first_ns <= *b.last_ns && *b.first_ns <= *a.last_ns;
}

Origins common_origins(const Session& a, const Session& b) noexcept {
  if (!share_time(a, b)) return {beginning(a), beginning(b)};
  const std::int64_t first_ns = std::min(*a.first_ns, *b.first_ns);
  return {first_ns, first_ns};
}

TickComparison compare_ticks(const Session& a, const Session& b) {
  TickComparison result;
  if (a.ticks.size() == 0 || b.ticks.size() == 0) return result;
  const Origins origins = common_origins(a, b);
  double squares = 0.0;
  std::size_t finite = 0;
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.ticks.size(); ++i) {
    const std::int64_t since_ns = a.ticks.at_ns[i] - origins.a_ns;
    j = nearest_tick(b.ticks, since_ns + origins.b_ns, j);
    if (2 * std::abs(b.ticks.at_ns[j] - origins.b_ns - since_ns) > std::int64_t{a.ticks.period_ns}) continue;
    const Instant now{.at_s = static_cast<double>(since_ns) * 1e-9,
                      .tick_a = i,
                      .tick_b = j,
                      .force_apart_N = distance(a.ticks.force, i, b.ticks.force, j),
                      .hands_apart_m = distance(a.ticks.hand, i, b.ticks.hand, j)};
    take(result, now, a.ticks.phase[i], b.ticks.phase[j]);
    if (!std::isfinite(now.force_apart_N)) continue;
    squares += now.force_apart_N * now.force_apart_N;
    ++finite;
  }
  if (finite > 0) result.force_rms_N = std::sqrt(squares / static_cast<double>(finite));
  return result;
}

}  // namespace telepalp::report
