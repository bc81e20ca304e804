#include "haptic_station/trials/cylinder_paths.h"

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

}  // namespace

plot::Chart cylinder_paths(const TrialResult& result) {
  plot::Chart chart{.title = "path at the inner object, with the force (2 mm a newton)",
                    .x = {.label = "x [mm]"},
                    .y = {.label = "y [mm]"}};
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
  return chart;
}

}  // namespace telepalp::trials
