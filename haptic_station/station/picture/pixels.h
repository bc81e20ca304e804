#pragma once

#include <algorithm>
#include <cmath>

#include "support/images/lettering.h"

namespace telepalp::station {

inline constexpr images::Rgb kWhite{255, 255, 255};
inline constexpr images::Rgb kInk{40, 40, 40};
inline constexpr images::Rgb kSkin{246, 221, 203};

[[nodiscard]] inline ColorImage blank(int width, int height, const images::Rgb& rgb) {
  ColorImage image{.width = width, .height = height, .rgb = {}};
  image.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  images::fill(image, {0, 0, width, height}, rgb);
  return image;
}

/// Index of a pixel in row-major order, in pixels. The pixel must lie in the image.
[[nodiscard]] inline std::size_t index_of(const ColorImage& image, int x, int y) noexcept {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}
[[nodiscard]] inline images::Rgb pixel(const ColorImage& image, int x, int y) noexcept {
  const std::size_t first = 3 * index_of(image, x, y);
  return {image.rgb[first], image.rgb[first + 1], image.rgb[first + 2]};
}
inline void set_pixel(ColorImage& image, int x, int y, const images::Rgb& rgb) noexcept {
  std::ranges::copy(rgb, image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * index_of(image, x, y)));
}

[[nodiscard]] inline images::Rgb mixed(const images::Rgb& a, const images::Rgb& b, double share_of_b) noexcept {
  images::Rgb out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<std::uint8_t>(std::lround((1.0 - share_of_b) * a[i] + share_of_b * b[i]));
  return out;
}

}  // namespace telepalp::station
