#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::images {

using Rgb = std::array<std::uint8_t, 3>;

/// In pixels; (x, y) is the upper left corner.
struct Rectangle {
  int x;
  int y;
  int width;
  int height;
};

/// Fills the part of the rectangle that lies in the image.
void fill(ColorImage& image, const Rectangle& where, const Rgb& rgb);

inline constexpr int kLetterWidth_dots = 6;   ///< including the gap to the next letter
inline constexpr int kLetterHeight_dots = 8;  ///< including the descender, as in p

/// Writes a line of text; (x, y) is its upper left corner. Each dot of a letter is a square with sides of `dot_px`
/// pixels. Letters that are not ASCII are shown as a question mark; dots outside the image are left out.
void write_text(ColorImage& image, int x, int y, std::string_view text, const Rgb& rgb, int dot_px);

/// Width [px] of the line that write_text() writes.
[[nodiscard]] int width_of(std::string_view text, int dot_px) noexcept;

/// The text in lines of at most `width_px`, broken between words; a word that is wider is broken anywhere. At least one
/// line.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text, int width_px, int dot_px);

}  // namespace telepalp::images
