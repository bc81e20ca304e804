#include "tools/replay/storm/storm.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/core/built_effects.h"
#include "tools/replay/run/session_run.h"

namespace telepalp::replay {

Result<StormOutcome> run_case(const StormCase& storm, const Spoil& spoil) {
  const Result<std::filesystem::path> file = scenes::find_scene(storm.scene);
  if (!file) return file.error();
  const Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  Result<Tape> tape = Tape::open(source_of(storm), {});
  if (!tape) return tape.error();
  Invariants invariants(storm.scenario, scene->control,
                        core::bank_of(scene->effects).stiffest_N_per_m(scene->control.limits.peak_N));
  const auto judge_ticks = [&](const std::vector<TickRecord>& ticks) {
    for (TickRecord tick : ticks) {
      if (spoil) spoil(tick);
      invariants.add(tick);
    }
  };
  const Result<RunResults> results =
      run_session(*tape, {.scene = *scene, .surface = {}, .recorded = nullptr, .seconds = storm.seconds, .threads = 1},
                  {{.scenario = storm.scenario,
                    .publish = [&](const wire::Message& message) { invariants.add(message); },
                    .on_ticks = judge_ticks}});
  if (!results) return results.error();
  return StormOutcome{invariants.violation(), invariants.ledgers(), results->seconds};
}

namespace {

/// The case, cut soon after its violation; nullopt: it does not fail.
Result<std::optional<StormCase>> cut_at_violation(const StormCase& storm, const Spoil& spoil) {
  const Result<StormOutcome> outcome = run_case(storm, spoil);
  if (!outcome) return outcome.error();
  if (!outcome->violation) return std::optional<StormCase>{};
  StormCase cut = storm;
  cut.seconds = std::min(storm.seconds, std::ceil(to_seconds(outcome->violation->at) + 0.5));
  return std::optional(cut);
}

}  // namespace

Result<StormCase> shrunk(StormCase failing, const Spoil& spoil) {
  Result<std::optional<StormCase>> cut = cut_at_violation(failing, spoil);
  if (!cut) return cut.error();
  if (*cut) failing = **cut;
  for (bool simpler = true; simpler;) {
    simpler = false;
    for (const Simplification simplify : simplifications()) {
      StormCase candidate = failing;
      simplify(candidate);
      if (command_line(candidate) == command_line(failing)) continue;
      cut = cut_at_violation(candidate, spoil);
      if (!cut) return cut.error();
      if (!*cut) continue;
      failing = **cut;
      simpler = true;
    }
  }
  return failing;
}

}  // namespace telepalp::replay
