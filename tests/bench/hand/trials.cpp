#include <algorithm>

#include "haptic_station/trials/trial_run.h"
#include "tests/bench/hand/studies.h"

// The four trials of paper S1 with a simulated hand, on a belly under a Kinect-like camera, at rest and breathing.
// Measures the largest force step, and the time in the skin without a contact.

namespace telepalp::bench::hand {
namespace {

constexpr double kBreathing_m = 0.005;

std::vector<Row> measure_trials(const std::string& name, double breathing_m, const Options& options) {
  constexpr device::Trial kTrials[] = {device::Trial::IndentSeveralPoints, device::Trial::MoveWithin,
                                       device::Trial::FindCylinder, device::Trial::FreeSearch};
  trials::TrialFigures figures[std::size(kTrials)];
  for_each_parallel(static_cast<int>(std::size(kTrials)), options, [&](int i) {
    const auto skin = trials::camera_skin({.breathing_m = breathing_m});
    figures[i] = trials::run_trial(kTrials[i], trials::paper_settings(), *skin).figures;
  });
  double step_N = 0.0;
  double unfelt_s = 0.0;
  double least_contact_s = 1e9;
  for (const trials::TrialFigures& one : figures) {
    step_N = std::max(step_N, one.worst_force_step_N);
    unfelt_s = std::max(unfelt_s, one.unfelt_s);
    least_contact_s = std::min(least_contact_s, one.contact_s);
  }
  return {at_most(name + ": force step in one tick, worst of the four trials", step_N, "N", 0.05),
          at_most(name + ": time over 2 mm deep in the true skin without contact, worst of the four trials",
                  1e3 * unfelt_s, "ms", 2.0),
          at_least(name + ": time in contact, least of the four trials", least_contact_s, "s", 3.0)};
}

}  // namespace

std::vector<Study> paper_trials() {
  std::vector<Study> studies;
  for (const auto& [name, breathing_m] :
       {std::pair{"trials/at rest", 0.0}, std::pair{"trials/breathing 5 mm", kBreathing_m}})
    studies.push_back({name, [name = std::string(name), breathing_m](const Options& options) {
                         return measure_trials(name, breathing_m, options);
                       }});
  return studies;
}

}  // namespace telepalp::bench::hand
