#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "haptic_station/surface/surface_settings.h"
#include "haptic_station/surface/surface_snapshot.h"
#include "proto/words/result.h"

namespace telepalp::probe {

/// A surface to touch offline, and what there is to say about it.
struct ProbedSurface {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  std::string remarks;
};

/// A cloud or mesh file. An organised cloud that a pinhole camera took is touched through its lattice, like a depth
/// image; any other as points. `unit_m`: metres for one unit of the file.
[[nodiscard]] Result<ProbedSurface> open_cloud(const std::filesystem::path& file, double unit_m,
                                               const surface::SurfaceSettings& settings);

/// A 16-bit depth PNG with its camera.textproto.
[[nodiscard]] Result<ProbedSurface> open_depth(const std::filesystem::path& png, const std::filesystem::path& camera,
                                               const surface::SurfaceSettings& settings);

}  // namespace telepalp::probe
