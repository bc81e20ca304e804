#pragma once

#include <vector>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/grid/grid_surface.h"

namespace telepalp::surface {

/// How nodes are fitted to pixels.
struct FitSettings {
  int step_px = 2;
  int radius_px = 6;
  double break_m = 0.015;
  int bridge_px = 2;
};

/// Nodes on a lattice over `box`, each with the position, normal and confidence of a weighted quadratic in inverse
/// depth over its window (in inverse depth a plane is linear in the pixels, so planes are exact). Windows without hole
/// or break cost three separable sums; others gather the pixels connected to their centre and solve by least squares.
/// `box` in the image; fills layout's lattice (columns, rows, left, top, step, origin) and the nodes.
void fit_nodes(const DepthField& depth, const Intrinsics& camera, const PixelBox& box, const FitSettings& settings,
               GridLayout& layout, std::vector<GridNode>& nodes);

}  // namespace telepalp::surface
