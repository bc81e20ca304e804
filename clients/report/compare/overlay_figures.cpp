#include "clients/report/compare/overlay_figures.h"

#include <algorithm>
#include <limits>
#include <set>

#include "clients/ar/messages/phases.h"
#include "clients/report/summary/summary.h"
#include "proto/wire/station/contact_force.h"

namespace telepalp::report {
namespace {

using plot::Chart;
using plot::Series;
using plot::Style;

constexpr std::string_view kFaintInk = "#667080";  // readable on white, fainter than the curves

/// An interval of the common time axis [s].
struct Window {
  double from_s = -std::numeric_limits<double>::infinity();
  double to_s = std::numeric_limits<double>::infinity();
};

double since_s(std::int64_t at_ns, std::int64_t origin_ns) { return static_cast<double>(at_ns - origin_ns) * 1e-9; }

/// One value for each tick in the window, as a curve.
template <class Value>
Series curve(std::string name, const Session& session, std::int64_t origin_ns, std::string_view color, Style style,
             const Window& window, Value value) {
  Series series{std::move(name), {}, {}, std::string(color), style};
  for (std::size_t i = 0; i < session.ticks.size(); ++i) {
    const double at_s = since_s(session.ticks.at_ns[i], origin_ns);
    if (at_s < window.from_s || at_s > window.to_s) continue;
    series.x.push_back(at_s);
    series.y.push_back(value(i));
  }
  return series;
}

template <class Value>
std::vector<Series> both(const Session& a, const Session& b, Style style_of_a, Style style_of_b, const Window& window,
                         Value value_of) {
  const Origins origins = common_origins(a, b);
  return {curve("A", a, origins.a_ns, kColorOfA, style_of_a, window, value_of(a)),
          curve("B", b, origins.b_ns, kColorOfB, style_of_b, window, value_of(b))};
}

Chart forces(const Session& a, const Session& b, const Window& window) {
  const auto norms = [](const Session& session) {
    return [&ticks = session.ticks, values = force_norm_N(session.ticks)](std::size_t i) {
      return wire::is_contact(ticks.phase[i]) ? values[i] : kUnknown;
    };
  };
  return {.title = "force of contact",
          .x = {"time [s]"},
          .y = {"|F| [N]", plot::Range{0.0, 0.0}},
          .series = both(a, b, Style::Line, Style::Dashed, window, norms)};
}

Chart states(const Session& a, const Session& b, const Window& window) {
  const auto levels = [](const Session& session) {
    return [&ticks = session.ticks](std::size_t i) { return ar::words_for(ticks.phase[i]).level; };
  };
  Chart chart{.title = "state",
              .x = {"time [s]"},
              .y = {"number of the state"},
              .series = both(a, b, Style::Step, Style::Step, window, levels),
              .height_px = 230.0};
  std::set<double> visited;
  for (Series& series : chart.series) visited.insert(series.y.begin(), series.y.end());
  for (double& level : chart.series[1].y) level += 0.12;  // beside the line of A, not on it
  for (const ar::PhaseWords& words : ar::kPhases)
    if (visited.contains(words.level)) {
      chart.y.ticks.push_back({words.level, std::string(words.mark)});
      chart.rules.push_back({words.level, std::string(words.words), std::string(kFaintInk)});
    }
  return chart;
}

Chart heights(const Session& a, const Session& b) {
  const auto height = [](const Session& session) {
    return [&ticks = session.ticks](std::size_t i) { return 1e3 * double{ticks.device[1][i]}; };
  };
  return {.title = "height of the end-effector",
          .x = {"time [s]"},
          .y = {"y [mm]"},
          .series = both(a, b, Style::Line, Style::Dashed, {}, height)};
}

Series ages_of(std::string name, const Session& session, std::int64_t origin_ns, std::string_view color, Style style) {
  Series series{std::move(name), {}, {}, std::string(color), style};
  for (const msg::StationState& state : session.states) {
    const auto at_ns = static_cast<std::int64_t>(state.stamp_ns());
    series.x.push_back(since_s(at_ns, origin_ns));
    series.y.push_back(state.surface_captured_ns() == 0
                           ? kUnknown
                           : 1e-6 *
                                 static_cast<double>(at_ns - static_cast<std::int64_t>(state.surface_captured_ns())));
  }
  return series;
}

}  // namespace

std::vector<Chart> overlaid(const Session& a, const Session& b, const TickComparison& comparison) {
  if (a.ticks.size() == 0 && b.ticks.size() == 0) return {};
  Chart difference{.title = "difference of the forces",
                   .x = {"time [s]"},
                   .y = {"|F_B - F_A| [N]", plot::Range{0.0, kFelt_N}},
                   .series = {{"", comparison.at_s, comparison.apart_N, std::string(plot::kBlack)}},
                   .height_px = 230.0};
  if (comparison.first_felt)
    difference.rules.push_back(
        {comparison.first_felt->at_s, "first felt difference", std::string(plot::kPurple), true});
  return {states(a, b, {}), forces(a, b, {}), std::move(difference), heights(a, b)};
}

std::vector<Chart> around(const Session& a, const Session& b, const Instant& instant) {
  const Window window{instant.at_s - 0.5, instant.at_s + 0.5};
  std::vector<Chart> charts{states(a, b, window), forces(a, b, window)};
  for (Chart& chart : charts) chart.rules.push_back({instant.at_s, "", std::string(plot::kPurple), true});
  return charts;
}

std::vector<Chart> overlaid_ages(const Session& a, const Session& b) {
  if (a.states.empty() && b.states.empty()) return {};
  const Origins origins = common_origins(a, b);
  return {{.title = "age of the surface under the hand",
           .x = {"time [s]"},
           .y = {"age [ms]", plot::Range{0.0, 0.0}},
           .series = {ages_of("A", a, origins.a_ns, kColorOfA, Style::Line),
                      ages_of("B", b, origins.b_ns, kColorOfB, Style::Dashed)},
           .height_px = 260.0}};
}

}  // namespace telepalp::report
