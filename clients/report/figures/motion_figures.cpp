#include "clients/report/figures/motion_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "clients/ar/messages/phases.h"
#include "clients/report/summary/summary.h"
#include "proto/wire/station/contact_force.h"
#include "support/plot/palette.h"

namespace telepalp::report {
namespace {

using plot::Band;
using plot::Chart;
using plot::Series;
using plot::Style;

constexpr double kHalfWidth = 472.0;
constexpr std::array<std::string_view, 3> kAxisNames{"x", "y", "z"};

std::vector<double> seconds_of(const Session& session) {
  std::vector<double> seconds;
  seconds.reserve(session.ticks.size());
  for (const std::int64_t at : session.ticks.at_ns)
    seconds.push_back(static_cast<double>(at - session.first_ns.value_or(0)) * 1e-9);
  return seconds;
}

std::vector<double> scaled(const std::vector<float>& values, double by) {
  std::vector<double> out;
  out.reserve(values.size());
  for (const float value : values) out.push_back(by * double{value});
  return out;
}

/// One band for each stay in a state.
std::vector<Band> bands_of(const Ticks& ticks, const std::vector<double>& seconds) {
  std::vector<Band> bands;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (i == 0 || ticks.phase[i] != ticks.phase[i - 1]) {
      const ar::PhaseWords& words = ar::words_for(ticks.phase[i]);
      bands.push_back(
          {seconds[i], seconds[i], std::string(words.color), std::string(words.words), std::string(words.mark)});
    }
    bands.back().to = seconds[i] + ticks.period_ns * 1e-9;
  }
  return bands;
}

/// `values` where `keep` is true, gaps elsewhere.
template <class Keep>
std::vector<double> only(std::vector<double> values, Keep keep) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!keep(i)) values[i] = kUnknown;
  return values;
}

bool is_contact(const Ticks& ticks, std::size_t i) { return wire::is_contact(ticks.phase[i]); }

/// Displacement of the device from the proxy at first contact along one axis (S1 eq. 8) [mm]; a gap out of contact.
std::vector<double> indentation_mm(const Ticks& ticks, std::size_t axis) {
  std::vector<double> out(ticks.size(), kUnknown);
  double first_contact = 0.0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (!is_contact(ticks, i)) continue;
    if (i == 0 || !is_contact(ticks, i - 1)) first_contact = double{ticks.proxy[axis][i]};
    out[i] = 1e3 * (double{ticks.device[axis][i]} - first_contact);
  }
  return out;
}

bool in_cylinder(msg::Phase phase) {
  return phase == msg::PHASE_CYLINDER_LATERAL || phase == msg::PHASE_CYLINDER_UPPER ||
         phase == msg::PHASE_AROUND_CYLINDER;
}

/// The path of the device in the plane of two axes, one curve for each state of the cylinder.
Chart cylinder_path(const Ticks& ticks, std::string title, std::size_t across, std::size_t up) {
  Chart chart{.title = std::move(title),
              .x = {std::string(kAxisNames[across]) + " [mm]"},
              .y = {std::string(kAxisNames[up]) + " [mm]"},
              .width_px = kHalfWidth,
              .height_px = 360.0};
  for (const ar::PhaseWords& words : ar::kPhases) {
    if (!in_cylinder(words.phase)) continue;
    const auto here = [&](std::size_t i) { return ticks.phase[i] == words.phase; };
    chart.series.push_back({std::string(words.words), only(scaled(ticks.device[across], 1e3), here),
                            only(scaled(ticks.device[up], 1e3), here), std::string(words.color), Style::Path});
  }
  return chart;
}

Chart state_chart(const Ticks& ticks, const std::vector<double>& seconds) {
  Chart chart{.title = "state", .x = {"time [s]"}, .y = {"number of the state"}, .height_px = 230.0};
  std::vector<double> levels;
  std::set<double> visited;
  for (const msg::Phase phase : ticks.phase) {
    levels.push_back(ar::words_for(phase).level);
    visited.insert(levels.back());
  }
  for (const ar::PhaseWords& words : ar::kPhases)
    if (words.level <= 3.0 || visited.contains(words.level))
      chart.y.ticks.push_back({words.level, std::string(words.mark)});
  chart.y.include = plot::Range{-3.0, 3.0};
  chart.series.push_back({"", seconds, std::move(levels), std::string(plot::kBlack), Style::Step});
  chart.bands = bands_of(ticks, seconds);
  return chart;
}

Chart position_chart(const Ticks& ticks, const std::vector<double>& seconds, std::string title) {
  Chart chart{.title = std::move(title), .x = {"time [s]"}, .y = {"height y [mm]"}};
  chart.bands = bands_of(ticks, seconds);
  chart.series = {{"end-effector", seconds, scaled(ticks.device[1], 1e3), std::string(plot::kBlack)},
                  {"tracked hand", seconds, scaled(ticks.hand[1], 1e3), std::string(plot::kVermilion), Style::Dashed}};
  return chart;
}

/// The force of contact with its components, and the drive's force, which no component shares.
Chart force_chart(const Ticks& ticks, const std::vector<double>& seconds) {
  const auto contact = [&](std::size_t i) { return is_contact(ticks, i); };
  const auto part = [&](std::size_t axis) { return only(scaled(ticks.force[axis], 1.0), contact); };
  Chart chart{.title = "force of contact, and of the drive", .x = {"time [s]"}, .y = {"force [N]"}};
  chart.series = {{"contact |F|", seconds, only(force_norm_N(ticks), contact), std::string(plot::kBlack)},
                  {"F_x", seconds, part(0), std::string(plot::kVermilion)},
                  {"F_y", seconds, part(1), std::string(plot::kBlue)},
                  {"F_z", seconds, part(2), std::string(plot::kGreen)},
                  {"drive |F|, not contact", seconds,
                   only(force_norm_N(ticks), [&](std::size_t i) { return !is_contact(ticks, i); }),
                   std::string(plot::kGrey), Style::Dashed}};
  return chart;
}

}  // namespace

Chart position_by_state(const Session& session) {
  return position_chart(session.ticks, seconds_of(session), "Height of the end-effector and of the tracked hand");
}

std::vector<Band> contact_bands(const Session& session) {
  const Ticks& ticks = session.ticks;
  const std::vector<double> seconds = seconds_of(session);
  std::vector<Band> bands;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (!is_contact(ticks, i)) continue;
    if (i == 0 || !is_contact(ticks, i - 1)) bands.push_back({seconds[i], seconds[i], "#8a8f98", "", ""});
    bands.back().to = seconds[i] + ticks.period_ns * 1e-9;
  }
  return bands;
}

std::vector<Chart> force_against_indentation(const Session& session) {
  const Ticks& ticks = session.ticks;
  const auto contact = [&](std::size_t i) { return is_contact(ticks, i); };
  std::vector<Chart> charts;
  constexpr std::array kColors{plot::kVermilion, plot::kBlue, plot::kGreen};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(kAxisNames[axis]);
    charts.push_back({.title = "Along " + name + (axis == 1 ? " (vertical)" : ""),
                      .x = {"indentation d_" + name + " [mm]", plot::Range{-1.0, 1.0}},
                      .y = {"force F_" + name + " [N]", plot::Range{-0.1, 0.1}},
                      .series = {{"", indentation_mm(ticks, axis), only(scaled(ticks.force[axis], 1.0), contact),
                                  std::string(kColors[axis]), Style::Path}},
                      .width_px = kHalfWidth});
  }
  charts.push_back({.title = "Magnitudes of force and indentation",
                    .x = {"indentation |d| [mm]", plot::Range{0.0, 1.0}},
                    .y = {"force |F| [N]", plot::Range{0.0, 0.1}},
                    .series = {{"", only(scaled(ticks.indentation_m, 1e3), contact), only(force_norm_N(ticks), contact),
                                std::string(plot::kBlack), Style::Path}},
                    .width_px = kHalfWidth});
  return charts;
}

std::vector<Chart> around_the_cylinder(const Session& session) {
  const Ticks& ticks = session.ticks;
  if (std::none_of(ticks.phase.begin(), ticks.phase.end(), in_cylinder)) return {};
  const std::vector<double> seconds = seconds_of(session);
  const auto here = [&](std::size_t i) { return in_cylinder(ticks.phase[i]); };
  Chart force{
      .title = "Force at objects under the skin", .x = {"time [s]"}, .y = {"force |F| [N]", plot::Range{0.0, 0.0}}};
  for (Band& band : bands_of(ticks, seconds))
    if (band.mark.starts_with('-')) force.bands.push_back(std::move(band));
  force.series.push_back({"|F|", seconds, only(force_norm_N(ticks), here), std::string(plot::kBlack)});
  return {cylinder_path(ticks, "Path of the end-effector, seen from the side", 0, 1),
          cylinder_path(ticks, "Path of the end-effector, seen from above", 0, 2), std::move(force)};
}

std::vector<Chart> timeline(const Session& session) {
  const Ticks& ticks = session.ticks;
  const std::vector<double> seconds = seconds_of(session);
  Chart position = position_chart(ticks, seconds, "position");
  position.series.insert(position.series.begin() + 1,
                         {"proxy on the skin", seconds,
                          only(scaled(ticks.proxy[1], 1e3), [&](std::size_t i) { return is_contact(ticks, i); }),
                          std::string(plot::kGreen)});
  position.bands.clear();
  return {state_chart(ticks, seconds), std::move(position), force_chart(ticks, seconds)};
}

}  // namespace telepalp::report
