#include "haptic_station/trials/trials_command.h"

#include <cstdio>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/trials/trial_report.h"
#include "support/program/options.h"

namespace telepalp::trials {
namespace {

program::Usage usage() {
  return {.program = "telepalp-station trials",
          .purpose = "runs the four trials of the palpation study with a simulated hand, in virtual time",
          .positional = "",
          .options = {{"out", "DIR", "where report.html and report.json go", "trials"},
                      {"scene", "FILE", "a *.scene.textproto; left out: the study's skin and cylinder"},
                      {"breathing-mm", "MM", "how far the patient's skin rises and falls", "0"}},
          .example = "telepalp-station trials --out trials"};
}

Result<VirtualStationSettings> settings_of(const program::Arguments& arguments) {
  if (!arguments.has("scene")) return paper_settings();
  const Result<scenes::Scene> scene = scenes::read_scene(arguments.text("scene"));
  if (!scene) return scene.error();
  VirtualStationSettings settings;
  settings.control = scene->control;
  settings.effects = scene->effects;
  settings.device = scene->simulated_device;
  settings.hand = scene->simulated_hand;
  return settings;
}

}  // namespace

int trials_command(int argc, const char* const* argv) {
  const auto read = program::read_arguments(usage(), argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  const program::Arguments& arguments = **read;
  const Result<double> breathing_mm = arguments.number("breathing-mm", 0.0, 50.0);
  if (!breathing_mm) return program::fail(breathing_mm.error(), program::kAskedWrongly);
  const Result<VirtualStationSettings> settings = settings_of(arguments);
  if (!settings) return program::fail(settings.error());
  std::vector<TrialResult> results;
  for (const auto trial : {device::Trial::IndentSeveralPoints, device::Trial::MoveWithin, device::Trial::FindCylinder,
                           device::Trial::FreeSearch}) {
    results.push_back(run_trial(trial, *settings, {.amplitude_m = *breathing_mm * 1e-3}));
    const TrialFigures& f = results.back().figures;
    std::printf("%-38s %3zu transitions, %5.2f s in contact, %5.2f N at most, steps to %.3f N\n", title(trial),
                results.back().transitions.size(), f.contact_s, f.most_force_N, f.worst_force_step_N);
  }
  const Result<void> written = write_report(results, arguments.text("out"));
  return written ? program::kDone : program::fail(written.error());
}

}  // namespace telepalp::trials
