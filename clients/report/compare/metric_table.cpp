#include "clients/report/compare/metric_table.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "clients/ar/messages/phases.h"

namespace telepalp::report {
namespace {

using Better = MetricPair::Better;

double seconds_in(const Summary& summary, msg::Phase phase) {
  for (std::size_t i = 0; i < ar::kPhases.size(); ++i)
    if (ar::kPhases[i].phase == phase) return summary.dwells[i].seconds;
  return kUnknown;
}

/// One figure of a session's summary. `matters`: a smaller difference is none for hand and eye, or is the measurement's
/// own error.
struct Row {
  const char* name;
  const char* unit;
  Better better;
  double matters;
  double (*value)(const Summary&);
};

double received_pct(const Summary& s) { return s.received_share() * 100.0; }

constexpr Row kRows[] = {
    {"largest force in contact", "N", Better::Neither, 0.05, [](const Summary& s) { return s.force_in_contact_max_N; }},
    {"deepest indentation", "mm", Better::Neither, 0.5, [](const Summary& s) { return s.indentation_max_mm; }},
    {"contacts", "", Better::Neither, 0.0, [](const Summary& s) { return static_cast<double>(s.touches); }},
    {"time in contact", "s", Better::Neither, 0.01, [](const Summary& s) { return s.contact_s; }},
    {"time in the state released", "s", Better::Less, 0.01,
     [](const Summary& s) { return seconds_in(s, msg::PHASE_RELEASED); }},
    {"time in the state faulted", "s", Better::Less, 0.0,
     [](const Summary& s) { return seconds_in(s, msg::PHASE_FAULTED); }},
    {"age of the touched surface, p50", "ms", Better::Less, 1.0, [](const Summary& s) { return s.surface_age_ms.p50; }},
    {"age of the touched surface, p99", "ms", Better::Less, 1.0, [](const Summary& s) { return s.surface_age_ms.p99; }},
    {"depth frame: encoded to received, p50", "ms", Better::Less, 1.0,
     [](const Summary& s) { return s.encoded_to_received_ms.p50; }},
    {"depth frame: encoded to received, p99", "ms", Better::Less, 1.0,
     [](const Summary& s) { return s.encoded_to_received_ms.p99; }},
    {"depth frame: camera to hand, p50", "ms", Better::Less, 1.0,
     [](const Summary& s) { return s.capture_to_touchable_ms.p50; }},
    {"depth frame: camera to hand, p99", "ms", Better::Less, 1.0,
     [](const Summary& s) { return s.capture_to_touchable_ms.p99; }},
    {"depth images in the file", "", Better::More, 0.0, [](const Summary& s) { return known(s.depth_images); }},
    {"depth images that became a surface", "", Better::More, 0.0, [](const Summary& s) { return known(s.surfaces); }},
    {"depth frames that the server sent to the station", "", Better::Neither, 0.0,
     [](const Summary& s) { return known(s.frames_sent); }},
    {"depth frames that the station received", "", Better::More, 0.0,
     [](const Summary& s) { return known(s.frames_received); }},
    {"depth frames received, of those sent", "%", Better::More, 0.5, received_pct},
    {"depth frames for the station that the server dropped", "", Better::Less, 0.0,
     [](const Summary& s) { return known(s.frames_dropped); }},
    {"error bound of the station's clock, p99", "ms", Better::Less, 1.0,
     [](const Summary& s) { return s.clock_error_ms.p99; }},
    {"predicted motion of the surface, p99", "mm", Better::Neither, 0.1,
     [](const Summary& s) { return s.surface_carried_mm.p99; }},
    {"lowest energy balance of the display (below 0: it created energy)", "mJ", Better::More, 0.1,
     [](const Summary& s) { return s.display_least_mJ; }},
    {"largest excess work on the hand in one contact (more than the measured skin would do)", "mJ", Better::Less, 1.0,
     [](const Summary& s) { return s.hand_excess_most_mJ; }},
    {"tick time, p99.9", "µs", Better::Less, 5.0, [](const Summary& s) { return s.tick_us.p999; }},
    {"lateness of a tick, p99.9", "µs", Better::Less, 5.0, [](const Summary& s) { return s.lateness_us.p999; }},
    {"ticks that missed their deadline", "", Better::Less, 0.0,
     [](const Summary& s) { return known(s.deadlines_missed); }},
    {"ticks that were not recorded", "", Better::Less, 0.0,
     [](const Summary& s) { return known(s.telemetry_dropped); }},
    {"warnings of warm motors", "", Better::Less, 0.0,
     [](const Summary& s) { return static_cast<double>(s.heat_warnings); }},
    {"damaged messages", "", Better::Less, 0.0,
     [](const Summary& s) { return static_cast<double>(s.damaged_messages); }},
    {"time from the first message to the last", "s", Better::Neither, 0.01, [](const Summary& s) { return s.seconds; }},
};

/// What matters in a replay's metric, by the unit with which its name ends.
double matters_in(const std::string& metric) {
  constexpr std::pair<std::string_view, double> kByUnit[] = {{"_N", 0.01}, {"_pct", 0.1}, {"_s", 1e-3},
                                                             {"_J", 1e-4}, {"_m", 1e-4},  {"_B", 0.0}};
  for (const auto& [unit, matters] : kByUnit)
    if (metric.ends_with(unit)) return matters;
  return 0.0;
}

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
  return by > std::max(matters, 1e-3 * std::max(std::abs(a), std::abs(b)));
}

bool MetricPair::same() const noexcept { return std::abs(b - a) <= matters; }

std::vector<MetricPair> metric_pairs(const Summary& a, const Summary& b) {
  std::vector<MetricPair> pairs;
  for (const Row& row : kRows) {
    const MetricPair pair{row.name, row.unit, row.value(a), row.value(b), row.better, row.matters};
    if (std::isfinite(pair.a) || std::isfinite(pair.b)) pairs.push_back(pair);
  }
  return pairs;
}

std::vector<MetricPair> replay_metric_pairs(const Run& a, const Run& b) {
  std::vector<MetricPair> pairs;
  if (!a.replay || !b.replay) return pairs;
  for (const auto& [name, value] : a.replay->figures) {
    const auto other = b.replay->figures.find(name);
    pairs.push_back({name, "", value, other == b.replay->figures.end() ? kUnknown : other->second, better_of(name),
                     matters_in(name)});
  }
  for (const auto& [name, value] : b.replay->figures)
    if (!a.replay->figures.contains(name))
      pairs.push_back({name, "", kUnknown, value, better_of(name), matters_in(name)});
  return pairs;
}

}  // namespace telepalp::report
