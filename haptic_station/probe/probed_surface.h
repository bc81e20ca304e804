#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "proto/words/result.h"

namespace telepalp::probe {

/// A surface for offline touch, with remarks about its file for the user.
struct ProbedSurface {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  std::string remarks;
  std::vector<Eigen::Vector3d> on_surface;  ///< points spread over the surface [m]: candidates for a path's spots
};

/// Properties that a cloud's or mesh's file does not contain.
struct CloudOptions {
  double unit_m = 1.0;        ///< metres for one unit of the file
  std::size_t samples = 0;    ///< number of points sampled from a mesh; 0: `spacing_m` decides
  double spacing_m = 0.0;     ///< between a mesh's samples; 0: reduced until the surface fits the mesh
  bool flip_normals = false;  ///< reverse the normals of a mesh or an unorganised cloud
  bool anyway = false;        ///< accept too coarse samples, a too noisy cloud or contradicting normals
};

/// Opens a cloud or mesh file. With Method::Grid, an organised cloud from a pinhole camera is converted to a depth
/// image's lattice. With Method::Paper, the points make a PaperSurface. Any other file or method makes a point-set
/// surface. Error: no finite point, all points at one place or on one line, or coordinates that cannot be metres.
[[nodiscard]] Result<ProbedSurface> open_cloud(const std::filesystem::path& file, const CloudOptions& options,
                                               const surface::SurfaceSettings& settings);

/// Opens a 16-bit depth PNG with the intrinsics in its camera.textproto.
[[nodiscard]] Result<ProbedSurface> open_depth(const std::filesystem::path& png, const std::filesystem::path& camera,
                                               const surface::SurfaceSettings& settings);

}  // namespace telepalp::probe
