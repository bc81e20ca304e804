#include "haptic_station/trials/trials_command.h"

#include <cstdio>
#include <vector>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/trials/trial_report.h"
#include "support/program/options.h"

namespace telepalp::trials {
namespace {

program::Usage usage() {
  return {.program = "telepalp-station trials",
          .purpose =
              "runs the four palpation trials of paper S1 (docs/sources.md) with a simulated hand, computed as "
              "fast as possible, not in real time",
          .positional = "",
          .options = {{"out", "DIR", "folder for report.html and report.json", "trials"},
                      {"scene", "FILE|NAME",
                       "scene file, or one of telepalp's own scenes; default: skin and cylinder as in paper S1"},
                      {"surface", "KIND",
                       "plane: a level skin that is known exactly; camera: a belly under a simulated depth camera; "
                       "both: one after the other",
                       "both"},
                      {"breathing-mm", "MM", "amplitude of the skin's motion by breathing, in millimetres", "0"}},
          .example = "telepalp-station trials --out trials"};
}

Result<VirtualStationSettings> settings_of(const program::Arguments& arguments) {
  if (!arguments.has("scene")) return paper_settings();
  const Result<std::filesystem::path> file = scenes::find_scene(arguments.text("scene"));
  if (!file) return file.error();
  const Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  if (core::has_slow_stage(scene->effects))
    return Error{.what = "the scene has an effect that a slow stage computes, and trials have none",
                 .where = file->string(),
                 .fix = "run telepalp-replay --scene SCENE instead"};
  VirtualStationSettings settings;
  settings.control = scene->control;
  settings.effects = core::bank_of(scene->effects);
  return settings;
}

void run_all(const VirtualStationSettings& settings, double breathing_m, bool by_camera,
             std::vector<TrialResult>& results) {
  for (const auto trial : {device::Trial::IndentSeveralPoints, device::Trial::MoveWithin, device::Trial::FindCylinder,
                           device::Trial::FreeSearch}) {
    const auto skin = by_camera ? camera_skin({.breathing_m = breathing_m}) : level_skin({.amplitude_m = breathing_m});
    TrialResult result = run_trial(trial, settings, *skin);
    result.surface = by_camera ? "camera" : "plane";
    const TrialFigures& f = result.figures;
    std::printf(
        "%-38s surface %-6s %3zu phase changes, %5.2f s in contact, %4.2f s inside the true skin without force, "
        "largest force %5.2f N, largest change of force in a tick %.3f N\n",
        title(trial), result.surface, result.transitions.size(), f.contact_s, f.unfelt_s, f.most_force_N,
        f.worst_force_step_N);
    results.push_back(std::move(result));
  }
}

int run_trials(const program::Arguments& arguments) {
  const Result<double> breathing_mm = arguments.number("breathing-mm", 0.0, 50.0);
  if (!breathing_mm) return program::fail(breathing_mm.error(), program::kAskedWrongly);
  const Result<VirtualStationSettings> settings = settings_of(arguments);
  if (!settings) return program::fail(settings.error());
  const std::string surface = arguments.text("surface");
  if (surface != "plane" && surface != "camera" && surface != "both")
    return program::fail({.what = "--surface '" + surface + "' is none of plane, camera and both",
                          .where = "telepalp-station trials",
                          .fix = "give one of them"},
                         program::kAskedWrongly);
  std::vector<TrialResult> results;
  if (surface != "camera") run_all(*settings, 1e-3 * *breathing_mm, false, results);
  if (surface != "plane") run_all(*settings, 1e-3 * *breathing_mm, true, results);
  const Result<void> written = write_report(results, arguments.text("out"));
  return written ? program::kDone : program::fail(written.error());
}

}  // namespace

int trials_command(int argc, const char* const* argv) { return program::run_program(usage(), argc, argv, run_trials); }

}  // namespace telepalp::trials
