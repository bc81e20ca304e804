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

/// A surface for offline touch, with remarks for the user about the file from which it was made.
struct ProbedSurface {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  std::string remarks;
  std::vector<Eigen::Vector3d> on_surface;  ///< points over the surface [m]: candidates for palpation_path()
};

/// How to read a cloud's or mesh's file. A depth lattice uses `unit_m` alone, a PaperSurface also `samples`.
struct CloudOptions {
  double unit_m = 1.0;        ///< metres for one unit of the file
  std::size_t samples = 0;    ///< number of points sampled from a mesh; 0: from `spacing_m`
  double spacing_m = 0.0;     ///< spacing of a mesh's samples; 0: reduced until the surface fits the mesh
  bool flip_normals = false;  ///< reverse the normals of a point-set surface
  bool anyway = false;        ///< accept too coarse samples, a too noisy cloud or contradicting normals
};

/// Opens a cloud or mesh file. With Method::Grid, an organised cloud from a pinhole camera gives a depth lattice. With
/// Method::Paper, the points give a PaperSurface. Other files and methods give a point-set surface. Error: an
/// unreadable file, points that span no surface, coordinates that cannot be metres, or an error of make_static_model().
[[nodiscard]] Result<ProbedSurface> open_cloud(const std::filesystem::path& file, const CloudOptions& options,
                                               const surface::SurfaceSettings& settings);

/// Opens a 16-bit grey depth PNG. `camera`: the camera.textproto with its intrinsics and depth unit.
[[nodiscard]] Result<ProbedSurface> open_depth(const std::filesystem::path& png, const std::filesystem::path& camera,
                                               const surface::SurfaceSettings& settings);

}  // namespace telepalp::probe
