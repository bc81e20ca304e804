#include "haptic_station/core/inside/inner_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "haptic_station/solids/solid_mesh.h"
#include "proto/wire/inside/inside_message.h"
#include "proto/wire/vector_message.h"
#include "proto/words/little_endian.h"

namespace telepalp::core {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostPoints = 36'000;  // of all layers: 0.65 MB, drawn by any computer
constexpr double kFinestGrid_m = 0.002;
// Side of a cube of the surface, in sides of a grid cell; below 1, so that no hole opens.
constexpr double kCellsPerGrid = 0.6;

/// Moves a point to the surface by Newton steps along the gradient, by at most `most_m`: a mean of surface points lies
/// off a curved surface.
Vector3d onto_surface(const solids::SolidTree& tree, const Vector3d& point, double most_m) {
  Vector3d at = point;
  for (int step = 0; step < 3; ++step) {
    const solids::SolidAt here = solids::solid_at(tree, at);
    const double slope = here.gradient.squaredNorm();
    if (!(slope > 1e-6)) return point;
    at -= here.m / slope * here.gradient;
  }
  return (at - point).norm() < most_m ? at : point;
}

/// One point for each cell of a grid: the mean of the points of `fine` in this cell. Triangles that shrink to an edge
/// are left out. Empty if `stop` was requested.
solids::SolidMesh clustered(const solids::SolidMesh& fine, double grid_m, const std::stop_token& stop) {
  solids::SolidMesh coarse;
  std::map<std::array<long, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> place_of;
  std::vector<double> count;
  for (const Vector3d& point : fine.points) {
    if (stop.stop_requested()) return {};
    const std::array<long, 3> key{std::lround(point.x() / grid_m), std::lround(point.y() / grid_m),
                                  std::lround(point.z() / grid_m)};
    const auto [found, added] = places.try_emplace(key, static_cast<std::uint32_t>(coarse.points.size()));
    if (added) coarse.points.emplace_back(Vector3d::Zero());
    if (added) count.push_back(0.0);
    coarse.points[found->second] += point;
    count[found->second] += 1.0;
    place_of.push_back(found->second);
  }
  for (std::size_t i = 0; i < coarse.points.size(); ++i) coarse.points[i] /= count[i];
  for (const auto& [a, b, c] : fine.triangles) {
    const std::array corners{place_of[a], place_of[b], place_of[c]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      coarse.triangles.push_back(corners);
  }
  return coarse;
}

/// The surface with at most `most_points` points: the grid grows until it fits. Meaningless if `stop` was requested.
Result<solids::SolidMesh> fitting_mesh(const solids::SolidTree& tree, std::size_t most_points,
                                       const std::stop_token& stop) {
  const Vector3d size_m = tree.box().high - tree.box().low;
  double grid_m = std::max(kFinestGrid_m, size_m.maxCoeff() / 128.0);
  for (int attempt = 0;; ++attempt) {
    const Result<solids::SolidMesh> fine = solids::mesh_of(tree, kCellsPerGrid * grid_m, stop);
    if (!fine) return fine.error();
    solids::SolidMesh mesh = clustered(*fine, grid_m, stop);
    if (mesh.points.size() <= most_points) {
      for (Vector3d& point : mesh.points)
        if (!stop.stop_requested()) point = onto_surface(tree, point, grid_m);
      return mesh;
    }
    if (attempt == 5)
      return Error{.what = "the mesh of the layer's surface needs more than " + std::to_string(most_points) + " points",
                   .where = "/station/inside",
                   .fix = "describe the layer by fewer or larger shapes"};
    grid_m *= 1.05 * std::sqrt(static_cast<double>(mesh.points.size()) / static_cast<double>(most_points));
  }
}

void pack(const solids::SolidMesh& mesh, msg::InnerStructure& structure) {
  Vector3d least = mesh.points.front();
  Vector3d most = least;
  for (const Vector3d& point : mesh.points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  const double step_m = std::max(1e-9, (most - least).maxCoeff() / 65535.0);
  wire::set_vector(*structure.mutable_least(), least);
  structure.set_step_m(step_m);
  for (const Vector3d& point : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      append_little_endian<std::uint16_t>(
          *structure.mutable_points(),
          static_cast<std::uint16_t>(std::clamp(std::lround((point - least)[axis] / step_m), 0L, 65535L)));
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      append_little_endian<std::uint16_t>(*structure.mutable_triangles(), static_cast<std::uint16_t>(corner));
}

void set_rotation(msg::Rotation& rotation, const Eigen::Quaterniond& q) {
  wire::set_vector(rotation, q.vec());
  rotation.set_w(q.w());
}

}  // namespace

std::optional<InnerSurfaces> inner_structures(std::span<const InnerLayer> layers, const std::stop_token& stop) {
  InnerSurfaces inside;
  if (layers.empty()) return inside;
  const std::size_t most_points = std::min(kMostPoints / layers.size(), wire::kMostStructurePoints);
  for (const auto& [layer, effect] : layers) {
    const Result<solids::SolidMesh> mesh = fitting_mesh(*layer->tree, most_points, stop);
    if (stop.stop_requested()) return std::nullopt;
    if (!mesh) inside.left_out.push_back("layer " + layer->name + ": " + to_string(mesh.error()));
    if (mesh && mesh->points.empty())
      inside.left_out.push_back("layer " + layer->name +
                                ": its shapes enclose no volume, or are too thin to be drawn (thinner than 1.2 mm, or "
                                "than 1/200 of the layer's length). fix: correct the shapes of the layer in the scene");
    if (!mesh || mesh->points.empty()) continue;
    msg::InnerStructure& structure = *inside.drawn.add_structures();
    structure.set_name(layer->name);
    structure.set_effect(effect);
    pack(*mesh, structure);
  }
  return inside;
}

void set_place(msg::InnerStructures& inside, const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
  const Transform<DepthCamera, HapticBase> camera_from_haptic = haptic_from_camera.inverse();
  wire::set_vector(*inside.mutable_haptic_origin_camera(), camera_from_haptic.iso.translation().eval());
  set_rotation(*inside.mutable_camera_from_haptic(), Eigen::Quaterniond(camera_from_haptic.iso.linear()));
}

}  // namespace telepalp::core
