#include <cmath>
#include <cstdio>
#include <string>
#include <variant>

#include "haptic_station/effects/layered_tissue.h"
#include "haptic_station/tissue/tissue_model.h"
#include "tests/bench/accuracy/accuracy_prism_tables.h"
#include "tests/bench/accuracy/accuracy_rms.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/accuracy_station_cost.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using tissue::TissueSettings;

constexpr std::string_view kNeedleScene = "amniocentesis";

/// Says on stderr what is measured next.
void tell(const std::string& what) { std::fprintf(stderr, "telepalp-bench accuracy: needle: %s\n", what.c_str()); }

/// The tissue with another net.
Result<std::shared_ptr<const tissue::TissueModel>> tissue_with(TissueSettings settings, double edge_m,
                                                               int subdivisions) {
  settings.net_edge_m = edge_m;
  settings.net.subdivisions = subdivisions;
  return tissue::make_tissue(settings);
}

scenes::Scene scene_of(const std::shared_ptr<const tissue::TissueModel>& model) {
  scenes::Scene scene = library_scene(kNeedleScene);
  for (effects::Recipe& recipe : scene.effects)
    if (auto* needle = std::get_if<effects::LayeredTissueSettings>(&recipe)) needle->model = model;
  return scene;
}

/// Places of contact up to 0.7 of the net's radius from its middle, where the load of the tip does not reach the rim.
/// The first one is the middle.
std::vector<Vector3d> places_m(double radius_m) {
  constexpr int kPlaces = 60;
  constexpr double kTurn = 2.399963;  // the golden angle: places at even distances
  std::vector<Vector3d> places;
  for (int i = 0; i < kPlaces; ++i) {
    const double r_m = 0.7 * radius_m * std::sqrt(static_cast<double>(i) / kPlaces);
    places.emplace_back(r_m * std::cos(kTurn * i), 0.0, r_m * std::sin(kTurn * i));
  }
  return places;
}

/// Relative errors of a net's force at `places`.
Distribution errors_of(const tissue::TissueModel& model, const std::vector<Vector3d>& places,
                       const std::vector<double>& finest) {
  Distribution errors;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const tissue::MeshPoint at = model.tree.nearest(places[i]);
    errors.add(std::abs(model.stiffness.felt_at(at.triangle, at.shares) / finest[i] - 1.0));
  }
  return errors;
}

/// The stiffness of the finest net at each place, relative to that at its middle, solved directly.
std::vector<double> finest_net(const TissueSettings& settings, const std::vector<Vector3d>& places) {
  constexpr double kEdge_m = 0.003;
  const tissue::SurfaceMesh mesh = tissue::lattice_disc(settings.net_radius_m, kEdge_m);
  const tissue::TriangleTree tree(mesh);
  std::vector<double> stiffness;
  for (const Vector3d& place_m : places) {
    const tissue::MeshPoint at = tree.nearest(place_m);
    const tissue::NetSettings net{.spread_m = settings.net.spread_m, .subdivisions = 1};
    stiffness.push_back(1.0 / tissue::net_compliance(mesh, net, at.triangle, at.shares));
  }
  const double middle = stiffness.front();
  for (double& value : stiffness) value /= middle;
  return stiffness;
}

/// Edge of the net and depth of the subdivision.
Result<PageTable> nets_table(const TissueSettings& settings, std::vector<Row>& rows) {
  PageTable table{.head = {"`net_edge_m`, mm", "`subdivisions`", "triangles", "force error %, p50", "p99",
                           "to read, ms", "station, % of a core"},
                  .rows = {}};
  const std::vector<Vector3d> places = places_m(settings.net_radius_m);
  tell("the finest net");
  const std::vector<double> finest = finest_net(settings, places);
  for (const double edge_m : {0.015, 0.01, 0.0075, 0.005})
    for (const int subdivisions : {0, 1, 2}) {
      if (edge_m < 0.0075 && subdivisions > 1) continue;  // takes a minute to read, and nobody needs it
      const std::string name = cell(1e3 * edge_m) + " mm, subdivided " + std::to_string(subdivisions) + " times";
      tell("net of " + name);
      const double before_us = thread_us();
      const auto model = tissue_with(settings, edge_m, subdivisions);
      if (!model) return model.error();
      const double read_ms = 1e-3 * (thread_us() - before_us);
      const Distribution errors = errors_of(**model, places, finest);
      const Result<station::StationCost> cost = cost_of_station(scene_of(*model), std::string(kNeedleScene));
      if (!cost) return cost.error();
      rows.push_back(measured("net of " + name + ": force error, p99", 100.0 * errors.p99(), "%"));
      rows.push_back(measured("net of " + name + ": time to read", read_ms, "ms"));
      rows.push_back(measured("net of " + name + ": the station", cost->share(), "% of a core"));
      const bool usual = edge_m == settings.net_edge_m && subdivisions == settings.net.subdivisions;
      const std::string edge = cell(1e3 * edge_m);
      table.rows.push_back({usual ? "**" + edge + "** (scenes)" : edge, std::to_string(subdivisions),
                            std::to_string((*model)->mesh.triangles().size()), cell(100.0 * errors.p50()),
                            cell(100.0 * errors.p99()), cell(read_ms), cell(cost->share())});
    }
  return table;
}

/// The tip goes in by 45 mm, rests, draws back by 10 mm, rests, and comes out, at 20 mm/s. [m], at `s` seconds.
Vector3d tip_m(double s) {
  constexpr double kSpeed_m_per_s = 0.02;
  constexpr struct {
    double to_m;
    double rest_s;
  } kLegs[]{{-0.015, 0.5}, {-0.045, 1.0}, {-0.035, 1.0}, {0.002, 0.0}};
  double y_m = 0.002;
  for (const auto& leg : kLegs) {
    const double takes_s = std::abs(leg.to_m - y_m) / kSpeed_m_per_s;
    if (s < takes_s) return {0.0, y_m + std::copysign(kSpeed_m_per_s * s, leg.to_m - y_m), 0.0};
    y_m = leg.to_m;
    if ((s -= takes_s) < leg.rest_s) break;
    s -= leg.rest_s;
  }
  return {0.0, y_m, 0.0};
}
constexpr double kPath_s = 8.0;

struct PathForces {
  std::vector<double> N;  ///< along y, at the ticks of 2 kHz
  double step_us = 0.0;   ///< processor time of a step
};

/// Forces of a tissue that takes `parts` steps in each tick.
PathForces forces_of(const std::shared_ptr<const tissue::TissueModel>& model, int parts) {
  tissue::LayeredTissue tissue(model);
  tissue::NeedleMotion needle{.tip_m = tip_m(0.0)};
  tissue.begin(needle);
  PathForces forces;
  const double before_us = thread_us();
  const int ticks = static_cast<int>(kPath_s / kTick_s);
  for (int i = 1; i <= ticks * parts; ++i) {
    needle.tip_m = tip_m(i * kTick_s / parts);
    const double force_N = tissue.step(needle, kTick_s / parts).force_N.y();
    if (i % parts == 0) forces.N.push_back(force_N);
  }
  forces.step_us = (thread_us() - before_us) / (ticks * parts);
  return forces;
}

Result<std::shared_ptr<const tissue::TissueModel>> tissue_with(TissueSettings settings, tissue::BulkLaw law) {
  for (tissue::LayerSettings& layer : settings.layers)
    if (layer.bulk) layer.bulk->law = law;
  return tissue::make_tissue(settings);
}

/// RMS of the difference of two forces [mN].
double apart_mN(const std::vector<double>& one_N, const std::vector<double>& other_N) {
  RootMeanSquare off;
  for (std::size_t i = 0; i < one_N.size(); ++i) off.add(one_N[i] - other_N[i]);
  return 1e3 * off.value();
}

constexpr std::pair<const char*, tissue::BulkLaw> kLaws[]{{"LAW_BRISTLE", tissue::BulkLaw::Bristle},
                                                          {"LAW_WINDOW", tissue::BulkLaw::Window},
                                                          {"LAW_PAPER", tissue::BulkLaw::Paper}};

/// Errors of the muscle's laws at each step length: against the same law with steps of 0.05 ms, and against the bristle
/// model. The station is measured with steps of 0.5 ms; for shorter ones, the time of the further steps is added.
Result<PageTable> steps_table(const TissueSettings& settings, std::vector<Row>& rows) {
  constexpr int kFine = 10;
  PageTable table{.head = {"`law`", "step ms", "force error mN, RMS", "from the bristle mN, RMS", "step µs",
                           "station, % of a core"},
                  .rows = {}};
  std::vector<double> bristle_N;
  for (const auto& [name, law] : kLaws) {
    tell(name);
    const auto model = tissue_with(settings, law);
    if (!model) return model.error();
    const Result<station::StationCost> cost = cost_of_station(scene_of(*model), std::string(kNeedleScene));
    if (!cost) return cost.error();
    const std::vector<double> fine_N = forces_of(*model, kFine).N;
    if (bristle_N.empty()) bristle_N = fine_N;
    for (const int parts : {1, 2, 5}) {
      const PathForces shown = forces_of(*model, parts);
      const double step_ms = 1e3 * kTick_s / parts;
      const double share = cost->share() + 1e-4 * shown.step_us * (parts - 1) / kTick_s;
      const std::string row = std::string(name) + ", steps of " + cell(step_ms) + " ms";
      rows.push_back(measured(row + ": force error, RMS", apart_mN(shown.N, fine_N), "mN"));
      rows.push_back(measured(row + ": time of a step", shown.step_us, "us"));
      rows.push_back(measured(row + ": the station", share, "% of a core"));
      table.rows.push_back(
          {std::string("`") + name + "`", parts == 1 ? "**" + cell(step_ms) + "** (2 kHz)" : cell(step_ms),
           cell(apart_mN(shown.N, fine_N)), cell(apart_mN(fine_N, bristle_N)), cell(shown.step_us), cell(share)});
    }
  }
  return table;
}

/// S4's detection of collisions and exact ones.
PageTable contact_table() {
  tell("ways to find a contact");
  PageTable table{.head = {"answer", "mesh", "tip, m/s", "method", "wrong", "of", "ns"}, .rows = {}};
  for (const ContactCase& one : contact_cases()) {
    const auto add = [&](const char* answer, const std::vector<ContactCost>& costs, std::uint64_t of) {
      for (const ContactCost& cost : costs)
        table.rows.push_back({answer, one.mesh, cell(one.speed_m_per_s), cost.method, std::to_string(cost.wrong),
                              std::to_string(of), cell(cost.ns)});
    };
    add("closest vertex", one.vertex, one.ticks);
    add("way through the mesh", one.crossing, one.crossings);
  }
  return table;
}

}  // namespace

Result<Section> needle_section() {
  Section section;
  const scenes::Scene scene = library_scene(kNeedleScene);
  const Result<PageTable> nets = nets_table(tissue_of(scene), section.rows);
  if (!nets) return nets.error();
  const Result<PageTable> steps = steps_table(tissue_of(scene), section.rows);
  if (!steps) return steps.error();
  const Result<PageTable> meshes = prism_meshes_table(section.rows);
  if (!meshes) return meshes.error();
  const Result<PageTable> rates = prism_rates_table(section.rows);
  if (!rates) return rates.error();
  section.parts = {{"nets", to_markdown(*nets)},
                   {"needle-steps", to_markdown(*steps)},
                   {"prism-meshes", to_markdown(*meshes)},
                   {"prism-rates", to_markdown(*rates)},
                   {"contact", to_markdown(contact_table())}};
  return section;
}

}  // namespace telepalp::bench
