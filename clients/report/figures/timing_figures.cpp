#include "clients/report/figures/timing_figures.h"

#include <algorithm>
#include <cmath>

#include "clients/report/figures/motion_figures.h"
#include "support/plot/histogram.h"
#include "support/plot/palette.h"

namespace telepalp::report {
namespace {

using plot::Chart;
using plot::Series;
using plot::Style;

Chart tick_histogram(std::string title, std::string label, const std::vector<float>& values_us, double budget_us) {
  const plot::Histogram histogram =
      plot::logarithmic_histogram(std::vector<double>(values_us.begin(), values_us.end()), 12);
  Series series{"", {}, {}, std::string(plot::kBlue), Style::Area};
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    series.x.push_back(histogram.edges[i]);
    series.y.push_back(histogram.counts[i] > 0.0 ? histogram.counts[i]
                                                 : 0.5);  // an empty bin ends at the axis, which is at 0.5
  }
  if (!histogram.counts.empty()) {
    series.x.push_back(histogram.edges.back());
    series.y.push_back(0.5);
  }
  Chart chart{.title = std::move(title),
              .x = {std::move(label), plot::Range{1.0, 1000.0}, true},
              .y = {"number of ticks", plot::Range{0.5, 10.0}, true},
              .series = {std::move(series)},
              .width_px = 472.0,
              .height_px = 280.0};
  if (budget_us > 0.0)
    chart.rules.push_back(
        {budget_us, "period " + std::to_string(std::lround(budget_us)) + " µs", std::string(plot::kVermilion), true});
  return chart;
}

/// Frames in each half second, as a rate.
Series rate_series(std::string name, std::vector<std::int64_t> captured_ns, std::int64_t origin_ns,
                   std::string_view color, Style style) {
  constexpr double kWindow_s = 0.5;
  Series series{std::move(name), {}, {}, std::string(color), style};
  std::sort(captured_ns.begin(), captured_ns.end());
  if (captured_ns.size() < 2) return series;
  const double first = static_cast<double>(captured_ns.front() - origin_ns) * 1e-9;
  const double last = static_cast<double>(captured_ns.back() - origin_ns) * 1e-9;
  constexpr double kMostWindows = 1e5;  // a stamp from another clock must not cause a million windows
  std::size_t next = 0;
  for (double from = first; from + kWindow_s <= last && (from - first) / kWindow_s < kMostWindows; from += kWindow_s) {
    std::size_t frames = 0;
    while (next < captured_ns.size() && static_cast<double>(captured_ns[next] - origin_ns) * 1e-9 < from + kWindow_s) {
      ++next;
      ++frames;
    }
    series.x.push_back(from);
    series.y.push_back(static_cast<double>(frames) / kWindow_s);
  }
  return series;
}

}  // namespace

std::vector<Chart> tick_times(const Session& session) {
  const double period_us = session.ticks.period_ns * 1e-3;
  return {tick_histogram("Time spent in a tick", "time [µs]", session.ticks.work_us, period_us),
          tick_histogram("Lateness of the wake-up for a tick", "lateness [µs]", session.ticks.late_us, period_us)};
}

plot::BarChart latency_by_stage(const Summary& summary) {
  const auto bar = [](std::string name, const Quantiles& values, std::string_view color) {
    return plot::Bar{std::move(name), values.p50, values.p99, std::string(color)};
  };
  return {"Latency of a depth image from the camera to the hand (bar: p50, whisker: p99)",
          "ms",
          {bar("capture to encoded", summary.capture_to_encoded_ms, plot::kSky),
           bar("encoded to received", summary.encoded_to_received_ms, plot::kSky),
           bar("received to decoded", summary.received_to_decoded_ms, plot::kSky),
           bar("decoded to touchable", summary.decoded_to_touchable_ms, plot::kSky),
           bar("capture to touchable, total", summary.capture_to_touchable_ms, plot::kBlue)}};
}

Chart surface_age(const Session& session) {
  Series age{"", {}, {}, std::string(plot::kBlue)};
  for (const msg::StationState& state : session.states) {
    const auto at = static_cast<std::int64_t>(state.stamp_ns());
    age.x.push_back(static_cast<double>(at - session.first_ns.value_or(0)) * 1e-9);
    age.y.push_back(state.surface_captured_ns() == 0
                        ? kUnknown
                        : static_cast<double>(at - static_cast<std::int64_t>(state.surface_captured_ns())) * 1e-6);
  }
  return {.title = "Age of the surface under the hand (grey: contact)",
          .x = {"time [s]"},
          .y = {"age [ms]", plot::Range{0.0, 0.0}},
          .series = {std::move(age)},
          .bands = contact_bands(session),
          .height_px = 240.0};
}

Chart frame_rate(const Session& session) {
  const std::int64_t origin = session.first_ns.value_or(0);
  std::vector<std::int64_t> touchable_ns;
  for (const msg::SurfaceReport& surface : session.surfaces)
    if (surface.touchable_ns() != 0) touchable_ns.push_back(static_cast<std::int64_t>(surface.touchable_ns()));
  Chart chart{
      .title = "Images per second, in each half second",
      .x = {"time [s]"},
      .y = {"images per second", plot::Range{0.0, 30.0}},
      .series = {rate_series("depth, taken by the camera", session.depth_captured_ns, origin, plot::kBlue, Style::Step),
                 rate_series("colour, taken by the camera", session.color_captured_ns, origin, plot::kVermilion,
                             Style::Step)},
      .height_px = 240.0};
  if (!touchable_ns.empty())
    chart.series.push_back(
        rate_series("depth, touchable at the station", touchable_ns, origin, plot::kGreen, Style::Step));
  return chart;
}

}  // namespace telepalp::report
