#pragma once

#include <memory>
#include <optional>

#include "haptic_station/surface/depth_field.h"
#include "haptic_station/surface/grid_surface.h"
#include "haptic_station/surface/motion_field.h"
#include "haptic_station/surface/surface_settings.h"

namespace telepalp::surface {

/// A grid surface that owns its nodes.
class GridSnapshot final : public GridSurface {
 public:
  GridSnapshot(const DepthField& depth, const Intrinsics& camera, const std::optional<Reach>& reach,
               const SurfaceSettings& settings);
  GridSnapshot(const GridSnapshot&) = delete;
  GridSnapshot& operator=(const GridSnapshot&) = delete;
  ~GridSnapshot() = default;

  /// For the builder, before the snapshot is shared: gives each node the motion seen at its pixel, along its normal.
  void carry_forward(const MotionField& field);

 private:
  std::vector<GridNode> storage_;
};

}  // namespace telepalp::surface
