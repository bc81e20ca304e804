#include "clients/report/compare/tick_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/// Forces at the ticks with contact in at least one run.
class ContactForces {
 public:
  void add(TickComparison& result, double apart_N, bool a, bool b) {
    if (!a && !b) return;
    ++result.contact;
    if (a != b) ++result.one_sided;
    if (std::isfinite(apart_N)) apart_N_.push_back(apart_N);
  }
  void summarise(TickComparison& result) && {
    if (apart_N_.empty()) return;
    double squares = 0.0;
    for (const double apart_N : apart_N_) squares += apart_N * apart_N;
    result.contact_rms_N = std::sqrt(squares / static_cast<double>(apart_N_.size()));
    result.contact_p99_N = quantiles(std::move(apart_N_)).p99;
  }

 private:
  std::vector<double> apart_N_;
};

/// The ticks of `ticks` for which `other` has no tick within half a period.
MissingTicks missing_in(const Ticks& other, std::int64_t other_origin_ns, const Ticks& ticks, std::int64_t origin_ns) {
  MissingTicks missing;
  std::size_t j = 0, length = 0, longest = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const std::int64_t since_ns = ticks.at_ns[i] - origin_ns;
    j = nearest_tick(other, since_ns + other_origin_ns, j);
    const bool there = 2 * std::abs(other.at_ns[j] - other_origin_ns - since_ns) <= std::int64_t{ticks.period_ns};
    length = there ? 0 : length + 1;
    missing.count += there ? 0 : 1;
    if (length <= longest) continue;
    longest = length;
    missing.until_s = 1e-9 * static_cast<double>(since_ns);
    missing.from_s = missing.until_s - 1e-9 * static_cast<double>((length - 1) * ticks.period_ns);
  }
  return missing;
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

std::size_t nearest_tick(const Ticks& ticks, std::int64_t at_ns, std::size_t from) noexcept {
  while (from + 1 < ticks.size() && std::abs(ticks.at_ns[from + 1] - at_ns) <= std::abs(ticks.at_ns[from] - at_ns))
    ++from;
  return from;
}

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
  ContactForces in_contact;
  result.missing_in_a = missing_in(a.ticks, origins.a_ns, b.ticks, origins.b_ns);
  result.missing_in_b = missing_in(b.ticks, origins.b_ns, a.ticks, origins.a_ns);
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
    in_contact.add(result, now.force_apart_N, wire::is_contact(a.ticks.phase[i]), wire::is_contact(b.ticks.phase[j]));
    if (!std::isfinite(now.force_apart_N)) continue;
    squares += now.force_apart_N * now.force_apart_N;
    ++finite;
  }
  std::move(in_contact).summarise(result);
  if (finite > 0) result.force_rms_N = std::sqrt(squares / static_cast<double>(finite));
  return result;
}

}  // namespace telepalp::report
