#include "tests/bench/accuracy/accuracy_prism_tables.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <variant>

#include "tests/bench/accuracy/accuracy_spring_prism.h"
#include "tests/bench/accuracy/accuracy_station_cost.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/fem/prisms.h"

namespace telepalp::bench {
namespace {

using tissue::ElementOrder;
using tissue::PrismGrid;

constexpr const char* kPrismScene = "prisms_to_compare";
constexpr double kPoisson = 0.45;  // of this scene's prisms

/// The scene's two prisms with another mesh.
Result<scenes::Scene> scene_with(const PrismGrid& grid) {
  scenes::Scene scene = library_scene(kPrismScene);
  for (effects::Recipe& recipe : scene.effects) {
    auto* prism = std::get_if<effects::FemPrismSettings>(&recipe);
    if (prism == nullptr) continue;
    tissue::PrismSettings settings = prism->model->settings;
    settings.grid = grid;
    auto model = tissue::make_prism_model(settings);
    if (!model) return model.error();
    prism->model = std::move(*model);
  }
  return scene;
}

PrismGrid even(int across, ElementOrder order) {
  return {.across = across, .along = 5 * across, .grading = 1.0, .order = order};
}

}  // namespace

Result<PageTable> prism_meshes_table(std::vector<Row>& rows) {
  struct Mesh {
    const char* name;
    PrismGrid grid;
    bool usual = false;
  };
  const Mesh meshes[]{
      {"linear, 1 x 5", even(1, ElementOrder::Linear)},      {"linear, 2 x 10", even(2, ElementOrder::Linear)},
      {"linear, 3 x 15", even(3, ElementOrder::Linear)},     {"quadratic, 1 x 5", even(1, ElementOrder::Quadratic)},
      {"quadratic, 2 x 6, shorter at the bottom", {}, true}, {"quadratic, 2 x 10", even(2, ElementOrder::Quadratic)}};
  PageTable table{.head = {"prism, cells across x along", "free nodes", "too stiff at the top by, %",
                           "at half height, the top's being right, %", "station, % of a core", "of it the two prisms"},
                  .rows = {}};
  const PrismCompliance finest = compliance_of(tissue::rubber(even(4, ElementOrder::Quadratic), kPoisson, 1.0));
  const double converged = converged_prism_per_Pa(kPoisson);
  const auto half_off = [&](const PrismCompliance& of) {
    return 100.0 * ((finest.half / finest.top) / (of.half / of.top) - 1.0);
  };
  for (const int across : {2, 3, 4}) {
    const PrismGrid grid = even(across, ElementOrder::Linear);
    const double off = half_off(compliance_of_springs(grid));
    const std::string name = "springs, " + std::to_string(across) + " x " + std::to_string(5 * across);
    const tissue::TetMesh mesh = *tissue::make_prism(grid);
    rows.push_back(measured("prism, " + name + ": too stiff at half height by", off, "%"));
    table.rows.push_back({name, std::to_string(mesh.nodes.size() - mesh.fixed), "fitted", cell(off), "–", "–"});
  }
  for (const Mesh& mesh : meshes) {
    std::fprintf(stderr, "telepalp-bench accuracy: needle: prism, %s\n", mesh.name);
    const auto body = tissue::rubber(mesh.grid, kPoisson, 1.0);
    const PrismCompliance compliance = compliance_of(body);
    const double off = 100.0 * (1.0 / (compliance.top * converged) - 1.0);
    const Result<scenes::Scene> scene = scene_with(mesh.grid);
    if (!scene) return scene.error();
    const Result<station::StationCost> cost = cost_of_station(*scene, kPrismScene);
    if (!cost) return cost.error();
    const double prisms = cost->share(station::Part::Effects);
    const std::string row = std::string("prism, ") + mesh.name;
    rows.push_back(measured(row + ": too stiff at the top by", off, "%"));
    rows.push_back(measured(row + ": too stiff at half height by", half_off(compliance), "%"));
    rows.push_back(measured(row + ": the station", cost->share(), "% of a core"));
    rows.push_back(measured(row + ": of it the two prisms", prisms, "% of a core"));
    const std::string name = mesh.usual ? "**" + std::string(mesh.name) + "** (default)" : mesh.name;
    table.rows.push_back({name, std::to_string(body->free_nodes()), cell(off), cell(half_off(compliance)),
                          cell(cost->share()), cell(prisms)});
  }
  return table;
}

Result<PageTable> prism_rates_table(std::vector<Row>& rows) {
  using std::chrono::milliseconds;
  std::fprintf(stderr, "telepalp-bench accuracy: needle: rates of the prism's local models\n");
  const Result<station::StationCost> cost = cost_of_station(library_scene(kPrismScene), kPrismScene);
  if (!cost) return cost.error();
  constexpr double kFull_per_s = 62.5;
  const double prisms = cost->share(station::Part::Effects);
  const std::vector<Nanoseconds> costs{milliseconds(4), milliseconds(12), milliseconds(32), milliseconds(64)};
  const std::vector<HandOverError> errors = hand_over_errors(costs);
  PageTable table{
      .head = {"run of the slow stage, ms", "local models, 1/s", "force error %, RMS", "station, % of a core"},
      .rows = {}};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const double cost_ms = 1e3 * to_seconds(costs[i]);
    const double station = cost->share() - prisms * (1.0 - errors[i].models_per_s / kFull_per_s);
    const std::string row = "prism, runs of " + cell(cost_ms) + " ms";
    rows.push_back(measured(row + ": force error, RMS", errors[i].percent, "%"));
    rows.push_back(measured(row + ": the station", station, "% of a core"));
    table.rows.push_back({cell(cost_ms), cell(errors[i].models_per_s), cell(errors[i].percent), cell(station)});
  }
  return table;
}

}  // namespace telepalp::bench
