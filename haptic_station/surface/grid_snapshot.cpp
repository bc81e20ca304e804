#include "haptic_station/surface/grid_snapshot.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/node_fit.h"

namespace telepalp::surface {
namespace {

/// Floats are exact to 0.1 µm within two metres of their origin: the grid's is near its points.
Eigen::Vector3d origin_for(const std::optional<Reach>& reach) {
  return reach && reach->centre.m.allFinite() ? reach->centre.m : Eigen::Vector3d(0.0, 0.0, 1.0);
}

}  // namespace

GridSnapshot::GridSnapshot(const DepthField& depth, const Intrinsics& camera, const std::optional<Reach>& reach,
                           const SurfaceSettings& settings) {
  layout_.origin_m = origin_for(reach);
  layout_.support_nodes = settings.support_nodes;
  layout_.gate_m = settings.gate_m;
  const int margin = settings.node_step_px * (1 + static_cast<int>(std::ceil(settings.support_nodes)));
  fit_nodes(depth, camera, box_in_reach(camera, reach, margin),
            {settings.node_step_px, settings.fit_radius_px, settings.break_m, settings.bridge_px}, layout_, storage_);
  nodes_ = storage_;
  points = static_cast<std::uint32_t>(
      std::count_if(storage_.begin(), storage_.end(), [](const GridNode& node) { return node.confidence > 0.0F; }));
  index_name = "depth lattice";
}

void GridSnapshot::carry_forward(const MotionField& field) {
  motion = field.model();
  for (int row = 0; row < layout_.rows; ++row)
    for (int column = 0; column < layout_.columns; ++column) {
      GridNode& node = storage_[static_cast<std::size_t>(row * layout_.columns + column)];
      if (node.confidence <= 0.0F) continue;
      const double u = layout_.left_px + column * layout_.step_px;
      const double v = layout_.top_px + row * layout_.step_px;
      const Eigen::Vector3d ray((u - layout_.camera.cx) / layout_.camera.fx,
                                (v - layout_.camera.cy) / layout_.camera.fy, 1.0);
      const Eigen::Vector3f normal(node.normal[0], node.normal[1], node.normal[2]);
      const float along_normal = normal.dot(ray.cast<float>());
      node.motion = field.terms_at(u, v);
      for (float& term : node.motion) term *= along_normal;
    }
}

}  // namespace telepalp::surface
