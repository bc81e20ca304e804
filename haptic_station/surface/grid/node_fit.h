#pragma once

#include <vector>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/grid/grid_surface.h"

namespace telepalp::surface {

/// Parameters of fit_nodes(), from SurfaceSettings.
struct FitSettings {
  int step_px = 2;         ///< distance between nodes
  int radius_px = 6;       ///< half side of the window of each node's fit
  double break_m = 0.015;  ///< depth step between neighbouring pixels that separates surfaces, at 1 m depth
  int bridge_px = 2;       ///< holes of at most this radius are bridged
};

/// Fits nodes on a lattice over `box`, a rectangle inside the image. Position, normal and confidence of a node come
/// from a weighted quadratic fit of inverse depth over its window; in inverse depth a plane is linear in the pixel
/// coordinates, so planes are exact. A window without hole or depth break is fitted in closed form, from separable
/// sums. A window of about half the radius replaces it on slanted skin (make_nodes()), and where only the smaller one
/// has no hole or break. Any other window is fitted by least squares to the pixels that are connected to its centre.
/// Reads `layout.origin_m`, to which the nodes are relative. Writes the lattice in `layout` (camera, columns, rows,
/// left, top, step) and the nodes.
void fit_nodes(const DepthField& depth, const Intrinsics& camera, const PixelBox& box, const FitSettings& settings,
               GridLayout& layout, std::vector<GridNode>& nodes);

}  // namespace telepalp::surface
