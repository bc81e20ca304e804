#pragma once

#include <vector>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/grid/grid_surface.h"

namespace telepalp::surface {

/// Parameters of fit_nodes(), from SurfaceSettings.
struct FitSettings {
  int step_px = 2;         ///< distance between nodes
  int radius_px = 6;       ///< half side of the wide window of each node's fit
  double break_m = 0.015;  ///< least depth step between neighbouring pixels that is a break, at 1 m depth (break_at())
  int bridge_px = 2;       ///< a node in a hole is fitted if a measured pixel is at most this far away
};

/// Fits nodes on a lattice over `box`, a rectangle inside the image. Position, normal and confidence of a node come
/// from a weighted quadratic fit of inverse depth over a window; in inverse depth a plane is linear in the pixel
/// coordinates, so planes are exact. Each node has a wide window, of `radius_px`, and a narrow one, of about half this
/// radius. A window without hole or depth break is fitted in closed form, from separable sums; make_nodes() blends both
/// fits. If only the narrow window is without hole or break, it is used alone. If neither is, the wide window is fitted
/// by least squares to the pixels that are connected to its centre. On skin that is steeper than 50 degrees off the
/// ray, where its depth in the image is far from a quadratic, a fit over its tangent plane takes over (fit_on_skin());
/// from 57 degrees on it is alone. Reads `layout.origin_m`, to which the nodes are relative. Writes the rest of the
/// lattice in `layout` (camera, columns, rows, left, top, step) and the nodes.
void fit_nodes(const DepthField& depth, const Intrinsics& camera, const PixelBox& box, const FitSettings& settings,
               GridLayout& layout, std::vector<GridNode>& nodes);

}  // namespace telepalp::surface
