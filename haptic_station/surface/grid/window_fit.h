#pragma once

#include <optional>

#include "haptic_station/surface/grid/window_mask.h"
#include "haptic_station/surface/grid/window_moments.h"

namespace telepalp::surface {

/// The tangent plane of the surface at a pixel, in inverse depth ρ: ρ ≈ at + across·du + down·dv [1/m, 1/(m·px)] at the
/// offset (du, dv) px from the pixel.
struct InverseDepthPlane {
  double at = 0.0;
  double across = 0.0;
  double down = 0.0;
};

/// A fit over a window with holes or depth breaks.
struct WindowFit {
  InverseDepthPlane plane;  ///< its `at` is minus InverseDepthView::reference_per_m
  double share = 0.0;       ///< share of the window's weight on pixels connected to the centre
};

/// Fits the window around (column, row) to the pixels that are connected to its centre without crossing a depth break.
/// If the centre is not measured, the nearest measured pixel within `bridge_px` replaces it, and the connected pixels
/// must have half of the window's weight. With at least 80 % of the weight the fit is quadratic, else linear. nullopt:
/// less than 25 % of the weight, no unique plane, or a depth that is not positive.
[[nodiscard]] std::optional<WindowFit> fit_window(const InverseDepthView& view, int column, int row,
                                                  const AxisWeights& axis, int bridge_px);

}  // namespace telepalp::surface
