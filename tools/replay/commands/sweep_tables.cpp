#include "tools/replay/commands/sweep_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "support/plot/heat_map.h"
#include "support/program/json.h"

namespace telepalp::replay {
namespace {

constexpr auto kShown =
    std::to_array<std::string_view>({"force_rmse_N", "true_force_rmse_N", "force_step_N", "contact_lost_pct",
                                     "surface_age_p50_s", "energy_J", "frames_in_time_pct", "frames_touched_pct"});

std::string number_or_nothing(double value, const char* form = "%.6g") {
  if (!std::isfinite(value)) return "";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), form, value);
  return text.data();
}

std::string number_or_unknown(double value) {
  return std::isfinite(value) ? number_or_nothing(value, "%.4g") : "unknown";
}

std::string left_padded(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::size_t width_of(std::string_view name) { return std::max<std::size_t>(12, name.size() + 2); }

std::string label(const SweepAxis& axis) {
  return std::string(axis.name) + (axis.unit.empty() ? "" : " [" + std::string(axis.unit) + "]");
}

std::vector<std::string> labels(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(number_or_nothing(value));
  return texts;
}

}  // namespace

std::string sweep_text(const SweepResult& result) {
  std::string text;
  for (const SweepAxis& axis : result.axes) text += left_padded(label(axis), 14);
  for (const std::string_view name : kShown) text += left_padded(std::string(name), width_of(name));
  text += "\n";
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    for (const double value : result.cells[i].values) text += left_padded(number_or_nothing(value), 14);
    for (const std::string_view name : kShown)
      text += left_padded(number_or_unknown(result.figures[i].*find_metric(name)->value), width_of(name));
    text += "\n";
  }
  return text;
}

std::string sweep_csv(const SweepResult& result) {
  std::string text;
  for (const SweepAxis& axis : result.axes) text += std::string(axis.name) + ",";
  for (const Metric& metric : metrics()) text += std::string(metric.name) + (&metric == &metrics().back() ? "\n" : ",");
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    for (const double value : result.cells[i].values) text += number_or_nothing(value) + ",";
    for (const Metric& metric : metrics())
      text += number_or_nothing(result.figures[i].*metric.value, "%.9g") + (&metric == &metrics().back() ? "\n" : ",");
  }
  return text;
}

std::string sweep_json(const SweepResult& result, const std::string& source) {
  program::Json json;
  json.begin_object();
  json.add("source", source);
  json.begin_list("cells");
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    json.begin_object();
    for (std::size_t axis = 0; axis < result.axes.size(); ++axis)
      json.add(result.axes[axis].name, result.cells[i].values[axis]);
    for (const Metric& metric : metrics()) json.add(metric.name, result.figures[i].*metric.value);
    json.end_object();
  }
  json.end_list();
  json.end_object();
  return std::move(json).finish();
}

std::string sweep_map(const SweepResult& result, const Metric& metric) {
  const SweepAxis& down = result.axes[0];
  const SweepAxis& across = result.axes[1];
  std::size_t others = 1;  // cells with equal values on the first two axes are neighbours
  for (std::size_t axis = 2; axis < result.axes.size(); ++axis) others *= result.axes[axis].values.size();
  plot::HeatMap map{.title = std::string(metric.name) + ": " + std::string(metric.what),
                    .x_label = label(across),
                    .y_label = label(down),
                    .columns = labels(across.values),
                    .rows = labels(down.values),
                    .values = {}};
  for (std::size_t i = 0; i < down.values.size() * across.values.size(); ++i)
    map.values.push_back(result.figures[i * others].*metric.value);
  return plot::to_svg(map);
}

}  // namespace telepalp::replay
