#pragma once

#include <cstddef>
#include <vector>

#include "haptic_station/surface/grid/window_moments.h"

namespace telepalp::surface {

/// One row of nodes, as arrays: what the fits say and what follows from it. Vectorised.
struct NodeRow {
  explicit NodeRow(std::size_t nodes);

  // in
  std::vector<float> wide_at, wide_across, wide_down;        ///< of the wide window; inverse depth less the reference
  std::vector<float> narrow_at, narrow_across, narrow_down;  ///< of the narrow one
  std::vector<float> wide;                                   ///< 1 where the wide window is whole, else 0
  std::vector<float> frames;                                 ///< behind the node's pixel, at least 1
  std::vector<float> ray_x;                                  ///< of the node's ray at 1 m

  // out
  std::vector<float> x, y, z;  ///< relative to the origin
  std::vector<float> normal_x, normal_y, normal_z;
  std::vector<float> deviation;
};

/// What is the same for a whole row.
struct NodeRowView {
  float fx = 1.0F, fy = 1.0F;  ///< focal lengths [px]
  float ray_y = 0.0F;          ///< of the row's rays at 1 m
  float origin_x = 0.0F, origin_y = 0.0F, origin_z = 0.0F;
  float reference_per_m = 0.0F;
  float wide_gain = 0.0F, narrow_gain = 0.0F;  ///< variance of a fit's centre over a pixel's
};

/// Blends the windows by slant and makes each node's place, normal and deviation. A window of pixels covers more of a
/// slanted surface, up to beyond its silhouette, while the noise along the normal falls with the same cosine: so the
/// window shrinks as the surface turns away.
void make_nodes(NodeRow& row, const NodeRowView& view);

}  // namespace telepalp::surface
