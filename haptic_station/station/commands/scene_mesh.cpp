#include "haptic_station/station/commands/scene_mesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "support/program/log.h"

namespace telepalp::station {
namespace {

/// Logs the share of the work that is done, every two seconds.
class ProgressLines {
 public:
  explicit ProgressLines(std::string of) : of_(std::move(of)) {}
  void operator()(double share) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(2)) return;
    last_ = now;
    program::log("telepalp-station scene",
                 of_ + ": " + std::to_string(std::lround(100.0 * share)) + " % of its box meshed");
  }

 private:
  std::string of_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void print_checks(const std::string& layer, const solids::CheckedMesh& made) {
  std::printf(
      "mesh of layer %s: closed, %zu part%s, Euler number %ld, %.5g cm3 (the solid: %.5g +- %.1g cm3), %zu points, %zu "
      "triangles (%zu of them slivers), cells down to %.2g mm%s\n",
      layer.c_str(), made.facts.parts, made.facts.parts == 1 ? "" : "s", made.facts.euler, 1e6 * made.facts.volume_m3,
      1e6 * made.volume.m3, 1e6 * made.volume.error_m3, made.mesh.points.size(), made.mesh.triangles.size(),
      made.facts.slivers, 1e3 * made.finest_m, made.meshed_twice ? ", meshed twice alike" : "");
}

}  // namespace

Result<std::optional<double>> smallest_cell_m(const program::Arguments& arguments) {
  if (!arguments.has("cell-mm")) return std::optional<double>{};
  const Result<double> cell_mm = arguments.number("cell-mm", 0.001, 100.0);
  if (!cell_mm) return cell_mm.error();
  return std::optional(1e-3 * *cell_mm);
}

Result<solids::CheckedMesh> mesh_of_layer(const scenes::Scene& scene, const program::Arguments& arguments) {
  const std::string name = arguments.text("layer");
  const std::vector<scenes::SceneLayer> layers = scene.layers();
  const auto layer =
      std::ranges::find_if(layers, [&](const auto& one) { return name.empty() || one.solid->name == name; });
  if (layer == layers.end())
    return Error{
        .what = name.empty() ? "the scene has no layer" : "the scene has no layer '" + name + "'",
        .where = name.empty() ? scene.name : "--layer",
        .fix =
            "name a scene with a layer, and one of its layers; telepalp-station scene check SCENE lists all effects, "
            "layers by their names"};
  Result<solids::CheckedMesh> made = checked_mesh_of(
      *layer->solid->tree,
      {.smallest_cell_m = *smallest_cell_m(arguments), .progress = ProgressLines("layer " + layer->solid->name)});
  if (!made) {
    Error error = made.error();
    error.what = "layer " + layer->solid->name + ": " + error.what;
    error.where = scene.name;
    return error;
  }
  print_checks(layer->solid->name, *made);
  return made;
}

}  // namespace telepalp::station
