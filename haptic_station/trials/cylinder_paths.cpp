#include "haptic_station/trials/cylinder_paths.h"

#include <utility>

namespace telepalp::trials {
namespace {

constexpr double kForceLine_mm_per_N = 2.0;
constexpr std::size_t kForceEvery = 10;  // samples: 50 ms

/// A part of the path in one phase; it has no name if the legend already shows its colour.
Curve stretch(control::Phase phase, bool named) {
  const bool upper = phase == control::Phase::ObjectUpper;
  return {named ? (upper ? "upper area" : "lateral area") : "", upper ? "#5e3c99" : "#e66101", {}, {}};
}

}  // namespace

Figure cylinder_paths(const TrialResult& result) {
  Figure figure{"path at the inner object, with the force (2 mm a newton)", "x [mm]", "y [mm]", {}, {}};
  std::vector<Curve> forces;
  control::Phase before = control::Phase::Released;
  bool in_legend[2] = {};
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const TrialSample& sample = result.samples[i];
    const control::Phase phase = std::exchange(before, sample.phase);
    if (sample.phase != control::Phase::ObjectUpper && sample.phase != control::Phase::ObjectLateral) continue;
    bool& named = in_legend[sample.phase == control::Phase::ObjectUpper ? 0 : 1];
    if (sample.phase != phase) figure.curves.push_back(stretch(sample.phase, !std::exchange(named, true)));
    const double x_mm = 1e3 * sample.device.m.x();
    const double y_mm = 1e3 * sample.device.m.y();
    figure.curves.back().x.push_back(x_mm);
    figure.curves.back().y.push_back(y_mm);
    if (i % kForceEvery != 0) continue;
    const Eigen::Vector3d line_mm = kForceLine_mm_per_N * sample.force.N;
    forces.push_back({"", "#999999", {x_mm, x_mm + line_mm.x()}, {y_mm, y_mm + line_mm.y()}});
  }
  figure.curves.insert(figure.curves.begin(), forces.begin(), forces.end());
  return figure;
}

}  // namespace telepalp::trials
