#include <algorithm>
#include <cmath>
#include <map>
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

/// Greatest change of the net's stiffness by one further subdivision, over contacts on the line from the middle to a
/// rim's vertex, in steps of a tenth of the way, up to 0.8 of it.
double change_by_subdivision(const tissue::TissueSettings& settings) {
  const tissue::SurfaceMesh mesh = tissue::lattice_disc(settings.net_radius_m, settings.net_edge_m);
  const tissue::TriangleTree tree(mesh);
  double worst = 0.0;
  for (int i = 0; i <= 8; ++i) {
    const tissue::MeshPoint at = tree.nearest({0.1 * i * settings.net_radius_m, 0.0, 0.03 * i * settings.net_radius_m});
    tissue::NetSettings net = settings.net;
    const double whole = tissue::net_compliance(mesh, net, at.triangle, at.shares);
    ++net.subdivisions;
    worst = std::max(worst, std::abs(whole / tissue::net_compliance(mesh, net, at.triangle, at.shares) - 1.0));
  }
  return worst;
}

/// Greatest relative step of the net's stiffness where a contact slides from one triangle to the next, and the
/// subdivided part of the net with it. Contacts up to 0.8 of the net's radius.
double step_to_the_next_triangle(const tissue::TissueSettings& settings) {
  const tissue::SurfaceMesh mesh = tissue::lattice_disc(settings.net_radius_m, settings.net_edge_m);
  const tissue::StiffnessMap map(mesh, settings.net);
  struct Side {
    std::uint32_t triangle;
    int corner;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> first;
  double worst = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles()[t][i];
      const std::uint32_t b = mesh.triangles()[t][(i + 1) % 3];
      const auto [other, fresh] = first.try_emplace(std::minmax(a, b), Side{t, i});
      if (fresh) continue;
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vector3d at_m = (1.0 - share) * mesh.vertices()[a] + share * mesh.vertices()[b];
        if (at_m.norm() > 0.8 * settings.net_radius_m) continue;
        Vector3d here = Vector3d::Zero();
        Vector3d there = Vector3d::Zero();
        here[i] = there[(other->second.corner + 1) % 3] = 1.0 - share;
        here[(i + 1) % 3] = there[other->second.corner] = share;
        worst = std::max(worst, std::abs(map.at(t, here) / map.at(other->second.triangle, there) - 1.0));
      }
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
    rows.push_back(at_most(std::string(name) + ": step of the net's stiffness from one triangle to the next",
                           100.0 * step_to_the_next_triangle(settings), "%", 1.0));
  }
  return rows;
}

}  // namespace telepalp::bench
