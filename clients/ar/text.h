#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// An sRGB colour with opacity, 0 to 255 each.
struct Ink {
  std::uint8_t red = 255, green = 255, blue = 255, alpha = 255;
};

/// Height of a line of text [px].
[[nodiscard]] int line_height_px() noexcept;

/// Width of `text` [px]. Letters that the font does not have count as "?".
[[nodiscard]] int text_width_px(std::string_view text) noexcept;

/// Draws UTF-8 `text` with its top left corner at (x, y); what falls outside of the image is cut off.
void draw_text(ColorImage& image, int x, int y, std::string_view text, const Ink& ink);

/// Blends one pixel; nothing outside of the image. `coverage` 0 to 1.
void blend(ColorImage& image, int x, int y, const Ink& ink, float coverage) noexcept;

}  // namespace telepalp::ar
