#pragma once

#include <cstddef>
#include <vector>

#include "haptic_station/surface/grid/window_moments.h"

namespace telepalp::surface {

/// One row of nodes as arrays, for vectorised code: fits of each node's two windows (fit_nodes()), and its geometry.
struct NodeRow {
  explicit NodeRow(std::size_t nodes);

  // inputs
  std::vector<float> wide_at, wide_across, wide_down;  ///< wide window: 1/z - reference_per_m [1/m], slopes [1/(m px)]
  std::vector<float> narrow_at, narrow_across, narrow_down;  ///< narrow window: as for the wide one
  std::vector<float> wide;                                   ///< 1 where the wide window has no hole or break, else 0
  std::vector<float> frames;                                 ///< number of frames averaged at the node's pixel, >= 1
  std::vector<float> ray_x;                                  ///< x of the node's ray at 1 m depth [m]

  // outputs
  std::vector<float> x, y, z;  ///< relative to the grid's origin [m]
  std::vector<float> normal_x, normal_y, normal_z;
  std::vector<float> deviation;  ///< standard deviation of the position along the normal [m]
  std::vector<float> facing;     ///< cosine between ray and normal
};

/// Values that all nodes of a row share.
struct NodeRowView {
  float fx = 1.0F, fy = 1.0F;                               ///< focal lengths [px]
  float ray_y = 0.0F;                                       ///< y of the row's rays at 1 m depth [m]
  float origin_x = 0.0F, origin_y = 0.0F, origin_z = 0.0F;  ///< of the grid, in the depth camera's frame [m]
  float reference_per_m = 0.0F;                             ///< subtracted from the inverse depths of NodeRow
  float wide_gain = 0.0F, narrow_gain = 0.0F;               ///< variance of the fit at the centre / of one pixel
};

/// Blends the fits of both windows by slant (the angle between ray and normal) and computes position, normal and
/// deviation of each node. On slanted skin, a window covers more area and may cross the silhouette, while the noise
/// along the normal falls with the cosine of the slant. The narrow window's weight therefore grows with the slant. From
/// 50 degrees on, fit_nodes() replaces the blend.
void make_nodes(NodeRow& row, const NodeRowView& view);

}  // namespace telepalp::surface
