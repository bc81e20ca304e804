#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "haptic_station/surface/grid/window_moments.h"

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

inline constexpr std::uint8_t kBrokenRight = 1;  ///< a mark: a surface ends towards the right neighbour
inline constexpr std::uint8_t kBrokenBelow = 2;  ///< towards the one below
inline constexpr std::uint8_t kMeasured = 4;

/// One bit for each pixel of a crop, rows of whole words, with a word of zeros before and after each.
class BitRows {
 public:
  BitRows(int width, int height);

  [[nodiscard]] std::uint64_t* row(int at) noexcept { return &words_[index(at)]; }
  /// Bits of `row` from `column` on, as many as a word has; columns may lie up to 64 outside.
  [[nodiscard]] std::uint32_t from(int column, int row) const noexcept {
    const auto bit = static_cast<unsigned>(column + 64);
    const std::uint64_t* words = &words_[index(row) - 1 + bit / 64];
    const unsigned shift = bit % 64;
    return static_cast<std::uint32_t>(shift == 0 ? words[0] : words[0] >> shift | words[1] << (64 - shift));
  }
  [[nodiscard]] std::size_t words() const noexcept { return stride_ - 2; }

 private:
  [[nodiscard]] std::size_t index(int row) const noexcept { return static_cast<std::size_t>(row) * stride_ + 1; }
  std::size_t stride_;
  std::vector<std::uint64_t> words_;
};

/// Pixels of inverse depth with what links them to a surface.
struct InverseDepthView {
  int width = 0;
  int height = 0;
  std::span<const float> per_m;  ///< 1/z less a reference
  const BitRows& measured;
  const BitRows& right;  ///< linked to the right neighbour
  const BitRows& below;  ///< linked to the one below
  float reference_per_m = 0.0F;
};

/// Fits the window around (column, row): only pixels connected to the centre without crossing a break take part. A
/// centre that was not measured stands on the nearest pixel within `bridge_px`, and only where at least half of the
/// window is there. Quadratic, or linear where a side is missing; nullopt where neither is determined.
[[nodiscard]] std::optional<WindowFit> fit_window(const InverseDepthView& view, int column, int row,
                                                  const AxisWeights& axis, int bridge_px);

}  // namespace telepalp::surface
