#include <algorithm>
#include <cmath>
#include <string>

#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;

/// Greatest |change of force| - stiffness x |motion| in a tick, outside rupture and slip, of needles that wander for
/// 1e5 ticks.
double worst_step_N(const tissue::TissueSettings& settings) {
  double worst_N = 0.0;
  for (const std::uint64_t seed : {1, 2}) {
    tissue::Insertion run(settings);
    tissue::wander(run, 100'000, seed);
    worst_N = std::max(worst_N, run.worst_step_N);
  }
  return worst_N;
}

struct Drop {
  double ticks = 0.0;   ///< from the puncture until the force has fallen to a tenth of the puncture's
  double step_N = 0.0;  ///< greatest fall of the force in a tick
};

/// The drop of the force after a puncture of the surface alone, without friction, at 20 mm/s.
Drop drop_of(const tissue::SurfaceSettings& given) {
  tissue::Insertion run = tissue::just_punctured(given, {0.0, 0.001, 0.0});
  const double tenth_N = 0.1 * run.force_N.norm();
  Drop drop;
  while (run.force_N.norm() > tenth_N) {
    const double before_N = run.force_N.norm();
    run.tick(run.needle.tip_m - Vector3d(0.0, 1e-5, 0.0));
    drop.step_N = std::max(drop.step_N, before_N - run.force_N.norm());
    ++drop.ticks;
  }
  return drop;
}

/// Greatest change of the net's stiffness by one subdivision, over contacts on the line from the middle to a rim's
/// vertex, in steps of a tenth of the way. Beyond 0.8 of it, the load reaches the rim.
double change_by_subdivision(const tissue::TissueSettings& settings) {
  const tissue::SurfaceMesh mesh = tissue::lattice_disc(settings.net_radius_m, settings.net_edge_m);
  const tissue::TriangleTree tree(mesh);
  double worst = 0.0;
  for (int i = 0; i <= 8; ++i) {
    const tissue::MeshPoint at = tree.nearest({0.1 * i * settings.net_radius_m, 0.0, 0.03 * i * settings.net_radius_m});
    tissue::NetSettings net = settings.net;
    net.subdivisions = 0;
    const double whole = tissue::net_compliance(mesh, net, at.triangle, at.shares);
    net.subdivisions = 1;
    worst = std::max(worst, std::abs(whole / tissue::net_compliance(mesh, net, at.triangle, at.shares) - 1.0));
  }
  return worst;
}

}  // namespace

std::vector<Row> run_needle_force_section() {
  std::vector<Row> rows;
  for (const std::string_view name : kNeedleScenes) {
    const scenes::Scene scene = library_scene(name);
    const tissue::TissueSettings& settings = tissue_of(scene);
    rows.push_back(at_most(std::string(name) + ": step of the force beyond the springs' own, outside rupture and slip",
                           worst_step_N(settings), "N", 0.05));
    for (const tissue::LayerSettings& layer : settings.layers) {
      if (!layer.surface) continue;
      const Drop drop = drop_of(*layer.surface);
      const std::string of = std::string(name) + ": " + layer.name + " ruptures: ";
      rows.push_back(at_least(of + "ticks of the drop", drop.ticks, "", 3.0));
      rows.push_back(measured(of + "greatest fall of the force in a tick", drop.step_N, "N"));
    }
    rows.push_back(at_most(std::string(name) + ": change of the force at a subdivision",
                           100.0 * change_by_subdivision(settings), "%", 1.0));
  }
  return rows;
}

}  // namespace telepalp::bench
