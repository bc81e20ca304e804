#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace telepalp::surface {

/// A surface in inverse depth around a pixel: ρ ≈ at + across·du + down·dv [1/m, 1/(m·px)].
struct InverseDepthPlane {
  double at = 0.0;
  double across = 0.0;
  double down = 0.0;
};

/// A fit over a window with holes or depth breaks.
struct WindowFit {
  InverseDepthPlane plane;
  double share = 0.0;  ///< of the window's weight that belongs to the centre's surface
};

/// Pixels of inverse depth with what ends a surface between them.
struct InverseDepthView {
  int width = 0;
  int height = 0;
  std::span<const float> per_m;          ///< 1/z; 0 is not measured
  std::span<const std::uint8_t> breaks;  ///< bit 0: broken towards the right neighbour; bit 1: towards the one below
};

inline constexpr std::uint8_t kBrokenRight = 1;
inline constexpr std::uint8_t kBrokenBelow = 2;

/// Fits the window of half side `weights.size() − 1` around (column, row): only pixels connected to the centre without
/// crossing a break take part. A centre that was not measured stands on the nearest pixel within `bridge_px`, and only
/// where at least half of the window is there. Quadratic, or linear where a side is missing; nullopt where neither is
/// determined. `weights[k]`: of a pixel k away, along each axis.
[[nodiscard]] std::optional<WindowFit> fit_window(const InverseDepthView& view, int column, int row,
                                                  std::span<const double> weights, int bridge_px);

}  // namespace telepalp::surface
