#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::images {

using Rgb = std::array<std::uint8_t, 3>;

/// An sRGB colour with opacity; each from 0 to 255.
struct Ink {
  std::uint8_t red = 255, green = 255, blue = 255, alpha = 255;
};

/// In pixels; (x, y) is the upper left corner.
struct Rectangle {
  int x;
  int y;
  int width;
  int height;
};

/// Fills the part of the rectangle that lies in the image.
void fill(ColorImage& image, const Rectangle& where, const Rgb& rgb);

/// Blends `ink` into one pixel with the weight `coverage` (0 to 1). Pixels outside the image are ignored.
void blend(ColorImage& image, int x, int y, const Ink& ink, float coverage) noexcept;

// The one font of telepalp's pictures: DejaVu Sans, the letters of ASCII and · – ° µ. Any other letter of UTF-8 text is
// shown as a question mark, as is each byte that is not UTF-8. `line_px`: height of a line, with ascenders and
// descenders, from 8 to kFullLine_px; the letters of a lower line are scaled down.

inline constexpr int kFullLine_px = 27;

/// Width of `text` on one line [px].
[[nodiscard]] int text_width_px(std::string_view text, int line_px = kFullLine_px) noexcept;

/// Draws a line of text; (x, y) is its upper left corner. What lies outside the image is left out.
void draw_text(ColorImage& image, int x, int y, std::string_view text, const Ink& ink, int line_px = kFullLine_px);

/// The text in lines of at most `width_px`, broken between words; a word that is wider is broken anywhere. At least one
/// line, and at least one letter a line.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text, int width_px, int line_px = kFullLine_px);

}  // namespace telepalp::images
