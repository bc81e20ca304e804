#include "clients/report/compare/contact_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "clients/report/summary/summary.h"
#include "proto/wire/station/contact_force.h"

namespace telepalp::report {
namespace {

constexpr double kStep_mm = 1.0;
constexpr double kLeast_mm = 2.0;  // below it, a small difference of place is a large one of force
constexpr double kMost_mm = 100.0;
constexpr std::size_t kFewestTicks = 10;  // in a step, 5 ms
constexpr std::int64_t kPair_ns = 400'000'000;
constexpr std::size_t kSettle = 40;         // ticks, 20 ms
constexpr std::size_t kFewestClipped = 40;  // 20 ms at one value
constexpr double kAtTheLimit = 1.0 - 1e-4;  // a clipped force is constant but for rounding
constexpr double kVaries = 1.03;

bool in_contact(const Ticks& ticks, std::size_t i) { return wire::is_contact(ticks.phase[i]); }

double median(std::vector<double> values) { return quantiles(std::move(values)).p50; }

Eigen::Vector3d at(const Axes& axes, std::size_t i) {
  return {double{axes[0][i]}, double{axes[1][i]}, double{axes[2][i]}};
}

/// The forces [N] in contact, by state and indentation in steps of kStep_mm.
std::map<std::pair<msg::Phase, std::size_t>, std::vector<double>> forces_by_depth(const Ticks& ticks) {
  std::map<std::pair<msg::Phase, std::size_t>, std::vector<double>> steps;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double depth_mm = 1e3 * double{ticks.indentation_m[i]};
    if (!in_contact(ticks, i) || !(depth_mm >= kLeast_mm) || depth_mm >= kMost_mm) continue;
    steps[{ticks.phase[i], static_cast<std::size_t>(depth_mm / kStep_mm)}].push_back(at(ticks.force, i).norm());
  }
  return steps;
}

double force_ratio(const Ticks& a, const Ticks& b) {
  const auto of_a = forces_by_depth(a), of_b = forces_by_depth(b);
  std::vector<double> ratios;
  for (const auto& [step, forces_N] : of_a) {
    const auto other = of_b.find(step);
    if (other == of_b.end() || std::min(forces_N.size(), other->second.size()) < kFewestTicks) continue;
    const double force_N = median(forces_N);
    if (force_N > 0.0) ratios.push_back(median(other->second) / force_N);
  }
  return median(std::move(ratios));
}

/// Indices of the ticks at which a contact begins and lasts at least kSettle ticks.
std::vector<std::size_t> beginnings(const Ticks& ticks) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i + kSettle < ticks.size(); ++i)
    if (in_contact(ticks, i) && !in_contact(ticks, i - 1) && in_contact(ticks, i + kSettle)) found.push_back(i);
  return found;
}

/// The unit vector into the body at the beginning `i` of a contact: the device's motion in the 50 ms before, or, for a
/// device that rests, against the force 20 ms later.
Eigen::Vector3d inwards(const Ticks& ticks, std::size_t i) {
  constexpr std::size_t kBefore = 100;
  constexpr double kRest_m = 2e-4;
  const Eigen::Vector3d moved = at(ticks.device, i) - at(ticks.device, i - std::min(i, kBefore));
  return moved.norm() > kRest_m ? moved.normalized() : -at(ticks.force, i + kSettle).normalized();
}

void add_beginnings(ContactComparison& result, const Session& a, const Session& b) {
  const Origins origins = common_origins(a, b);
  const std::vector<std::size_t> of_a = beginnings(a.ticks), of_b = beginnings(b.ticks);
  result.contacts_a = of_a.size();
  result.contacts_b = of_b.size();
  std::vector<double> deeper_mm;
  for (const std::size_t i : of_a) {
    const std::int64_t since_ns = a.ticks.at_ns[i] - origins.a_ns;
    const auto apart = [&](std::size_t j) { return std::abs(b.ticks.at_ns[j] - origins.b_ns - since_ns); };
    const auto nearest =
        std::min_element(of_b.begin(), of_b.end(), [&](std::size_t x, std::size_t y) { return apart(x) < apart(y); });
    if (nearest == of_b.end() || apart(*nearest) > kPair_ns) continue;
    const double mm = 1e3 * inwards(a.ticks, i).dot(at(b.ticks.device, *nearest) - at(a.ticks.device, i));
    if (std::isfinite(mm)) deeper_mm.push_back(mm);
  }
  result.pairs = deeper_mm.size();
  result.deeper_mm = median(std::move(deeper_mm));
}

/// Whether the force of `own` is clipped: it stays at its largest value while the other run's force is larger and
/// varies.
std::optional<Clipped> clipped(const Session& own, const Session& other, bool own_is_b) {
  const Origins origins = common_origins(own, other);
  const std::vector<double> force_N = force_norm_N(own.ticks), beside_N = force_norm_N(other.ticks);
  double most_N = 0.0;
  for (std::size_t i = 0; i < force_N.size(); ++i)
    if (in_contact(own.ticks, i) && std::isfinite(force_N[i])) most_N = std::max(most_N, force_N[i]);
  Clipped found{.in_b = own_is_b, .at_N = most_N};
  double least_N = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = 0; i < force_N.size(); ++i) {
    if (!in_contact(own.ticks, i) || !(force_N[i] >= kAtTheLimit * most_N)) continue;
    j = nearest_tick(other.ticks, own.ticks.at_ns[i] - origins.a_ns + origins.b_ns, j);
    if (!(beside_N[j] > most_N)) continue;
    ++found.ticks;
    found.other_N = std::max(found.other_N, beside_N[j]);
    least_N = std::min(least_N, beside_N[j]);
  }
  if (found.ticks < kFewestClipped || !(found.other_N > kVaries * least_N)) return std::nullopt;
  return found;
}

}  // namespace

ContactComparison compare_contacts(const Session& a, const Session& b) {
  ContactComparison result;
  if (a.ticks.size() == 0 || b.ticks.size() == 0) return result;
  result.force_ratio = force_ratio(a.ticks, b.ticks);
  add_beginnings(result, a, b);
  result.clipped = clipped(b, a, true);
  if (!result.clipped) result.clipped = clipped(a, b, false);
  return result;
}

}  // namespace telepalp::report
