#pragma once

#include <memory>
#include <optional>
#include <span>

#include "haptic_station/surface/depth/block_depths.h"
#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/grid/grid_surface.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/temporal/motion_field.h"

namespace telepalp::surface {

/// A grid surface that owns its nodes. They cover the image region that `reach` projects to; nullopt: the whole image.
class GridSnapshot final : public GridSurface {
 public:
  GridSnapshot(const DepthField& depth, const Intrinsics& camera, const std::optional<Reach>& reach,
               const SurfaceSettings& settings);
  GridSnapshot(const GridSnapshot&) = delete;
  GridSnapshot& operator=(const GridSnapshot&) = delete;
  ~GridSnapshot() = default;

  /// Sets each node's predicted motion along its normal from the motion field at the node's pixel. SurfaceBuilder calls
  /// it before other threads get the snapshot.
  void carry_forward(const MotionField& field);
  /// Lets the surface fade where an object has hidden it for long. `shown`: 1 for each block of `lattice` whose surface
  /// counts fully, 0 for one that has none. SurfaceBuilder calls it before other threads get the snapshot.
  void fade(const BlockLattice& lattice, std::span<const float> shown);

 private:
  std::vector<GridNode> storage_;
};

}  // namespace telepalp::surface
