#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "haptic_station/surface/grid/window_moments.h"

namespace telepalp::surface {

inline constexpr std::uint8_t kBrokenRight = 1;  ///< flag: depth break between this pixel and its right neighbour
inline constexpr std::uint8_t kBrokenBelow = 2;  ///< flag: depth break between this pixel and the one below
inline constexpr std::uint8_t kMeasured = 4;     ///< flag: the pixel has a depth

/// A bitmap with one bit per pixel of a rectangle of the image. Each row is padded to whole 64-bit words and has a word
/// of zeros before and after it.
class BitRows {
 public:
  BitRows(int width, int height);

  [[nodiscard]] std::uint64_t* row(int at) noexcept { return &words_[index(at)]; }
  /// The 32 bits of `row` from `column` on. `column` may lie up to 64 pixels outside; bits outside the row are zero.
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

/// A rectangle of inverse depths, with bitmaps of measured pixels and of links between neighbours on one surface.
struct InverseDepthView {
  int width = 0;
  int height = 0;
  std::span<const float> per_m;  ///< 1/z - reference_per_m, row by row; 0: not measured
  const BitRows& measured;
  const BitRows& right;  ///< pixel and right neighbour are on one surface
  const BitRows& below;  ///< pixel and the one below are on one surface
  float reference_per_m = 0.0F;
};

struct Pixel {
  int column = 0;
  int row = 0;
};

/// The pixels of a square window that belong to one surface: bit k of `rows[l]` is the pixel k columns to the right of,
/// and l rows below, the window's top left corner.
struct WindowMask {
  std::array<std::uint32_t, kMostSide> rows{};
  Pixel start;  ///< the measured pixel, in the view, to which all others are connected
};

/// All pixels of a window without hole or depth break.
[[nodiscard]] WindowMask whole_window(Pixel centre, int radius) noexcept;

/// The pixels within `radius` of (column, row) that are connected to it without crossing a depth break. If this pixel
/// is not measured, the nearest measured one within `bridge_px` replaces it; nullopt: there is none.
[[nodiscard]] std::optional<WindowMask> connected_pixels(const InverseDepthView& view, int column, int row, int radius,
                                                         int bridge_px);

}  // namespace telepalp::surface
