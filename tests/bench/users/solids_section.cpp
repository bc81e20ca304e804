#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "support/isosurface/mesh_facts.h"
#include "support/models/point_model.h"
#include "tests/bench/users/known_solids.h"
#include "tests/bench/users/sections.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

constexpr double kMostVolumeError = 0.01;

/// What `telepalp-station scene mesh` made of a solid.
struct MeshRun {
  bool refused = false;
  isosurface::MeshFacts facts{};
  std::size_t triangles = 0;
  double seconds = 0.0;
};

Result<MeshRun> meshed(const UsersPlace& place, const KnownSolid& solid) {
  const std::filesystem::path scene = place.scratch / "one.scene.textproto", mesh = place.scratch / "one.ply";
  std::filesystem::remove(mesh);
  std::ofstream(scene) << "haptic_from_camera { translation_m { y: 0.8 } rotation_vector_rad { x: 1.5708 } }\n"
                       << "effects { solid { name: \"one\" polish: \"" << solid.polish << "\" } }\n";
  const auto before = std::chrono::steady_clock::now();
  // Through a shell, so that what the program prints does not mix with this benchmark's figures.
  support::ChildProcess program("/bin/sh", {"-c", "exec \"$0\" scene mesh \"$1\" --out \"$2\" >\"$3\" 2>&1",
                                            (place.programs / "telepalp-station").string(), scene.string(),
                                            mesh.string(), (place.scratch / "log.txt").string()});
  const std::optional<int> code = program.wait(std::chrono::minutes(10));
  MeshRun outcome{.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count()};
  outcome.refused = code == 1 && !std::filesystem::exists(mesh);
  if (outcome.refused) return outcome;
  const Result<models::PointModel> model = models::read_point_model(mesh);
  if (!model) return model.error();
  isosurface::Mesh read;
  for (const Eigen::Vector3f& point : model->points) read.points.emplace_back(point.cast<double>());
  read.triangles = model->triangles;
  outcome.facts = facts_of(read);
  outcome.triangles = read.triangles.size();
  return outcome;
}

double volume_error(const KnownSolid& solid, const MeshRun& outcome) {
  return std::abs(outcome.facts.volume_m3 / solid.volume_m3 - 1.0);
}

bool is_right(const KnownSolid& solid, const MeshRun& outcome) {
  return outcome.facts.open_edges == 0 && outcome.facts.parts == solid.parts && outcome.facts.euler == solid.euler &&
         volume_error(solid, outcome) <= kMostVolumeError;
}

void tell(const KnownSolid& solid, const MeshRun& outcome) {
  if (outcome.refused)
    std::fprintf(stderr, "  %s: refused, after %.1f s\n", solid.name.c_str(), outcome.seconds);
  else
    std::fprintf(stderr,
                 "  %s: %s: %zu open edges, parts %zu (%zu), Euler %ld (%ld), volume %+.2f %%, %zu triangles, %.1f s\n",
                 solid.name.c_str(), is_right(solid, outcome) ? "right" : "WRONG", outcome.facts.open_edges,
                 outcome.facts.parts, solid.parts, outcome.facts.euler, solid.euler,
                 100.0 * (outcome.facts.volume_m3 / solid.volume_m3 - 1.0), outcome.triangles, outcome.seconds);
}

}  // namespace

Result<std::vector<Row>> run_solids_section(const UsersPlace& place) {
  double wrong = 0.0, refused = 0.0, worst = 0.0, longest_s = 0.0;
  std::size_t triangles = 0, slivers = 0;
  const std::vector<KnownSolid> solids = known_solids();
  for (const KnownSolid& solid : solids) {
    const Result<MeshRun> outcome = meshed(place, solid);
    if (!outcome) return outcome.error();
    tell(solid, *outcome);
    longest_s = std::max(longest_s, outcome->seconds);
    refused += outcome->refused ? 1.0 : 0.0;
    if (outcome->refused) continue;
    wrong += is_right(solid, *outcome) ? 0.0 : 1.0;
    worst = std::max(worst, volume_error(solid, *outcome));
    triangles += outcome->triangles;
    slivers += outcome->facts.slivers;
  }
  double invented = 0.0;
  for (const KnownSolid& solid : solids_without_mesh()) {
    const Result<MeshRun> outcome = meshed(place, solid);
    invented += outcome && outcome->refused ? 0.0 : 1.0;
  }
  const std::string of = "CSG meshes of " + std::to_string(solids.size()) + " expressions: ";
  return std::vector<Row>{
      at_most(of + "wrong volume (1 %), parts or Euler number, and not refused", wrong, "", 0.0),
      at_most(of + "refused", refused, "", 2.0),
      at_most(of + "largest volume error of a mesh", 100.0 * worst, "%", 100.0 * kMostVolumeError),
      at_most(of + "triangles without area",
              triangles == 0 ? 100.0 : 100.0 * static_cast<double>(slivers) / static_cast<double>(triangles), "%", 0.1),
      at_most("solids that touch, are empty or have no end: meshed all the same", invented, "", 0.0),
      measured(of + "longest time for one", longest_s, "s")};
}

}  // namespace telepalp::bench
