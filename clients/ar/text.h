#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// An sRGB colour with opacity; each from 0 to 255.
struct Ink {
  std::uint8_t red = 255, green = 255, blue = 255, alpha = 255;
};

/// Height of one line of text [px].
[[nodiscard]] int line_height_px() noexcept;

/// Width of `text` [px]. A character that the font lacks counts as "?".
[[nodiscard]] int text_width_px(std::string_view text) noexcept;

/// Draws UTF-8 `text` with its top left corner at (x, y); text outside the image is clipped.
void draw_text(ColorImage& image, int x, int y, std::string_view text, const Ink& ink);

/// Blends `ink` into one pixel with the weight `coverage` (0 to 1). Pixels outside the image are ignored.
void blend(ColorImage& image, int x, int y, const Ink& ink, float coverage) noexcept;

}  // namespace telepalp::ar
