#include "clients/report/compare/metric_table.h"

#include <algorithm>
#include <cmath>

#include "clients/ar/messages/phases.h"

namespace telepalp::report {
namespace {

using Better = MetricPair::Better;

double known(const std::optional<std::uint64_t>& count) { return count ? static_cast<double>(*count) : kUnknown; }

double seconds_in(const Summary& summary, msg::Phase phase) {
  for (std::size_t i = 0; i < ar::kPhases.size(); ++i)
    if (ar::kPhases[i].phase == phase) return summary.dwells[i].seconds;
  return kUnknown;
}

/// One figure of a session's summary.
struct Row {
  const char* name;
  const char* unit;
  Better better;
  double (*value)(const Summary&);
};

constexpr Row kRows[] = {
    {"largest force in contact", "N", Better::Neither, [](const Summary& s) { return s.force_in_contact_max_N; }},
    {"deepest indentation", "mm", Better::Neither, [](const Summary& s) { return s.indentation_max_mm; }},
    {"contacts", "", Better::Neither, [](const Summary& s) { return static_cast<double>(s.touches); }},
    {"time in contact", "s", Better::Neither, [](const Summary& s) { return s.contact_s; }},
    {"time in the state released", "s", Better::Less,
     [](const Summary& s) { return seconds_in(s, msg::PHASE_RELEASED); }},
    {"time in the state faulted", "s", Better::Less,
     [](const Summary& s) { return seconds_in(s, msg::PHASE_FAULTED); }},
    {"age of the touched surface, p50", "ms", Better::Less, [](const Summary& s) { return s.surface_age_ms.p50; }},
    {"age of the touched surface, p99", "ms", Better::Less, [](const Summary& s) { return s.surface_age_ms.p99; }},
    {"depth frame: encoded to received, p50", "ms", Better::Less,
     [](const Summary& s) { return s.encoded_to_received_ms.p50; }},
    {"depth frame: encoded to received, p99", "ms", Better::Less,
     [](const Summary& s) { return s.encoded_to_received_ms.p99; }},
    {"depth frame: camera to hand, p50", "ms", Better::Less,
     [](const Summary& s) { return s.capture_to_touchable_ms.p50; }},
    {"depth frame: camera to hand, p99", "ms", Better::Less,
     [](const Summary& s) { return s.capture_to_touchable_ms.p99; }},
    {"depth frames that the station received", "", Better::More,
     [](const Summary& s) { return known(s.frames_received); }},
    {"depth frames for the station that the server dropped", "", Better::Less,
     [](const Summary& s) { return known(s.frames_dropped); }},
    {"predicted motion of the surface, p99", "mm", Better::Neither,
     [](const Summary& s) { return s.surface_carried_mm.p99; }},
    {"lowest energy balance of the display (below 0: it created energy)", "mJ", Better::More,
     [](const Summary& s) { return s.display_least_mJ; }},
    {"largest excess work on the hand in one contact (more than the measured skin would do)", "mJ", Better::Less,
     [](const Summary& s) { return s.hand_excess_most_mJ; }},
    {"tick time, p99.9", "µs", Better::Less, [](const Summary& s) { return s.tick_us.p999; }},
    {"lateness of a tick, p99.9", "µs", Better::Less, [](const Summary& s) { return s.lateness_us.p999; }},
    {"ticks that missed their deadline", "", Better::Less, [](const Summary& s) { return known(s.deadlines_missed); }},
    {"ticks that were not recorded", "", Better::Less, [](const Summary& s) { return known(s.telemetry_dropped); }},
    {"warnings of warm motors", "", Better::Less,
     [](const Summary& s) { return static_cast<double>(s.heat_warnings); }},
    {"damaged messages", "", Better::Less, [](const Summary& s) { return static_cast<double>(s.damaged_messages); }},
    {"time from the first message to the last", "s", Better::Neither, [](const Summary& s) { return s.seconds; }},
};

/// Whether a replay's metric is better when it is larger. All others are errors, ages, losses or costs.
Better better_of(const std::string& metric) {
  if (metric == "energy_J" || metric == "frames_in_time_pct" || metric == "frames_touched_pct") return Better::More;
  if (metric == "frames" || metric == "force_max_N" || metric == "phase_changes") return Better::Neither;
  return Better::Less;
}

}  // namespace

bool MetricPair::worse() const noexcept {
  if (better == Better::Neither || !std::isfinite(a) || !std::isfinite(b)) return false;
  const double by = better == Better::Less ? b - a : a - b;
  return by > 1e-3 * std::max(std::abs(a), std::abs(b));
}

std::vector<MetricPair> metric_pairs(const Summary& a, const Summary& b) {
  std::vector<MetricPair> pairs;
  for (const Row& row : kRows) {
    const MetricPair pair{row.name, row.unit, row.value(a), row.value(b), row.better};
    if (std::isfinite(pair.a) || std::isfinite(pair.b)) pairs.push_back(pair);
  }
  return pairs;
}

std::vector<MetricPair> replay_metric_pairs(const Run& a, const Run& b) {
  std::vector<MetricPair> pairs;
  if (!a.replay || !b.replay) return pairs;
  for (const auto& [name, value] : a.replay->figures) {
    const auto other = b.replay->figures.find(name);
    pairs.push_back({name, "", value, other == b.replay->figures.end() ? kUnknown : other->second, better_of(name)});
  }
  for (const auto& [name, value] : b.replay->figures)
    if (!a.replay->figures.contains(name)) pairs.push_back({name, "", kUnknown, value, better_of(name)});
  return pairs;
}

}  // namespace telepalp::report
