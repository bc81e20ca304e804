#include "haptic_station/trials/cylinder_paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/plot/palette.h"

namespace telepalp::trials {
namespace {

constexpr double kForceLine_mm_per_N = 2.0;
constexpr std::size_t kForceEvery = 10;  // samples: 50 ms

/// A part of the path in one phase, still without points.
plot::Series path_in(control::Phase phase) {
  const bool upper = phase == control::Phase::ObjectUpper;
  return {.name = upper ? "upper area" : "lateral area",
          .x = {},
          .y = {},
          .color = std::string(upper ? plot::kPurple : plot::kBlue),
          .style = plot::Style::Path};
}

plot::Series force_line(double x_mm, double y_mm, const Eigen::Vector3d& force_N) {
  const Eigen::Vector3d line_mm = kForceLine_mm_per_N * force_N;
  return {.name = "",
          .x = {x_mm, x_mm + line_mm.x()},
          .y = {y_mm, y_mm + line_mm.y()},
          .color = std::string(plot::kGrey),
          .style = plot::Style::Path};
}

plot::Range data_range(const plot::Chart& chart, std::vector<double> plot::Series::*axis) {
  std::vector<double> all;
  for (const plot::Series& one : chart.series) all.insert(all.end(), (one.*axis).begin(), (one.*axis).end());
  return plot::range_of(all, {});
}

/// A range of `length`, with the same middle.
plot::Range lengthened(const plot::Range& range, double length) {
  const double middle = 0.5 * (range.least + range.most);
  return {middle - 0.5 * length, middle + 0.5 * length};
}

/// Widens one axis so that a millimetre is as long along x as along y. Otherwise the force lines point elsewhere, and a
/// press without sideways movement fills the whole width.
void scale_axes_equally(plot::Chart& chart) {
  const plot::Frame frame = plot::frame_of(chart);
  const double width_px = std::abs(frame.x_px.most - frame.x_px.least);
  const double height_px = std::abs(frame.y_px.most - frame.y_px.least);
  const plot::Range x = data_range(chart, &plot::Series::x);
  const plot::Range y = data_range(chart, &plot::Series::y);
  const double mm_per_px = std::max((x.most - x.least) / width_px, (y.most - y.least) / height_px);
  chart.x.include = lengthened(x, mm_per_px * width_px);
  chart.y.include = lengthened(y, mm_per_px * height_px);
}

}  // namespace

plot::Chart cylinder_paths(const TrialResult& result) {
  plot::Chart chart{.title = "path of the end-effector at the inner object; lines: force, 2 mm long per newton",
                    .x = {.label = "x [mm]"},
                    .y = {.label = "y [mm]"},
                    .height_px = 500.0};
  std::vector<plot::Series> forces;
  control::Phase before = control::Phase::Released;
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const TrialSample& sample = result.samples[i];
    const control::Phase phase = std::exchange(before, sample.phase);
    if (sample.phase != control::Phase::ObjectUpper && sample.phase != control::Phase::ObjectLateral) continue;
    if (sample.phase != phase) chart.series.push_back(path_in(sample.phase));
    const double x_mm = 1e3 * sample.device.m.x();
    const double y_mm = 1e3 * sample.device.m.y();
    chart.series.back().x.push_back(x_mm);
    chart.series.back().y.push_back(y_mm);
    if (i % kForceEvery == 0) forces.push_back(force_line(x_mm, y_mm, sample.force.N));
  }
  chart.series.insert(chart.series.begin(), forces.begin(), forces.end());
  if (!chart.series.empty()) scale_axes_equally(chart);
  return chart;
}

}  // namespace telepalp::trials
