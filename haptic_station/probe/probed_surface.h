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

/// A surface to touch offline, and what there is to say about it.
struct ProbedSurface {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  std::string remarks;
  std::vector<Eigen::Vector3d> on_surface;  ///< some of its points [m], spread over it: where a path may begin
};

/// What a cloud's or mesh's file does not say of itself.
struct CloudOptions {
  double unit_m = 1.0;          ///< metres for one unit of the file
  std::size_t samples = 16000;  ///< of a mesh
  bool flip_normals = false;    ///< of a mesh, or of a cloud without a camera's order
};

/// A cloud or mesh file. An organised cloud that a pinhole camera took is touched through its lattice, like a depth
/// image; any other as points. Without a single finite point, with all in one place or on one line, or in a unit that
/// is no metre: an error.
[[nodiscard]] Result<ProbedSurface> open_cloud(const std::filesystem::path& file, const CloudOptions& options,
                                               const surface::SurfaceSettings& settings);

/// A 16-bit depth PNG with its camera.textproto.
[[nodiscard]] Result<ProbedSurface> open_depth(const std::filesystem::path& png, const std::filesystem::path& camera,
                                               const surface::SurfaceSettings& settings);

}  // namespace telepalp::probe
