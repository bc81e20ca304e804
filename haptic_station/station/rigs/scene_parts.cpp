#include "haptic_station/station/rigs/scene_parts.h"

#include <cstdio>

#include "haptic_station/core/built_effects.h"
#include "support/program/log.h"
#include "support/program/terminal.h"

namespace telepalp::station {

Result<SceneParts> read_parts(const scenes::Scene& scene, const std::filesystem::path& scene_file, bool anyway) {
  SceneParts parts;
  if (!scene.surface.empty()) {
    const Result<surface::SurfaceSettings> surface = surface::surface_settings(scene.surface);
    if (!surface) return surface.error();
    parts.surface = *surface;
  }
  if (scene.hand_trace) {
    Result<tracking::HandTrace> trace = tracking::read_hand_trace(*scene.hand_trace);
    if (!trace) return trace.error();
    parts.trace = std::move(trace).value();
  }
  if (scene.model) {
    Result<StaticPatient> model = open_static_patient(scene, scene_file.parent_path(), anyway);
    if (!model) return model.error();
    parts.model = std::move(model).value();
  }
  return parts;
}

void print_warnings(const scenes::Scene& scene) {
  const bool colour = program::takes_colour(stderr);
  for (const Error& warning : scene.warnings)
    std::fprintf(stderr, "%swarning:%s %s\n", colour ? "\x1b[33m" : "", colour ? "\x1b[0m" : "",
                 program::escaped(to_string(warning)).c_str());
}

std::string validity_in_words(const scenes::Scene& scene) {
  std::string effects;
  const effects::EffectBank bank = core::bank_of(scene.effects);
  for (const effects::EffectBill& line : bank.bill())
    effects += (effects.empty() ? std::string() : std::string(", ")) + line.name;
  return scene.name + ": the scene is valid; " + scene.purpose + (scene.purpose.empty() ? "" : "; ") +
         "effects: " + effects;
}

}  // namespace telepalp::station
