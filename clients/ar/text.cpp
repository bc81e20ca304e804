#include "clients/ar/text.h"

#include <array>
#include <cmath>

namespace telepalp::ar {
namespace {

struct Glyph {
  std::uint32_t code;
  int advance_px;
  std::array<std::string_view, 27> rows;  ///< one hexadecimal digit per pixel: its coverage
};

#include "clients/ar/font_data.inc"

const Glyph& glyph_of(std::uint32_t code) noexcept {
  for (const Glyph& glyph : kGlyphs)
    if (glyph.code == code) return glyph;
  return glyph_of('?');
}

/// Removes the next code point from UTF-8 text. A malformed one, or one of more than three bytes, becomes '?'.
std::uint32_t next_code(std::string_view& text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  std::uint32_t code = first;
  bool well_formed = length <= text.size() && (first < 0x80 || first >= 0xC0) && first < 0xF8;
  for (std::size_t i = 1; well_formed && i < length; ++i) well_formed = (byte(i) & 0xC0) == 0x80;
  if (!well_formed) {
    text.remove_prefix(1);
    return '?';
  }
  if (length == 2) code = (first & 0x1F) << 6 | (byte(1) & 0x3F);
  if (length == 3) code = (first & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F);
  text.remove_prefix(length);
  return length == 4 ? '?' : code;
}

float coverage(char digit) noexcept {
  return static_cast<float>(digit <= '9' ? digit - '0' : digit - 'a' + 10) / 15.0F;
}

}  // namespace

int line_height_px() noexcept { return kLineHeight_px; }

int text_width_px(std::string_view text) noexcept {
  int width = 0;
  while (!text.empty()) width += glyph_of(next_code(text)).advance_px;
  return width;
}

void blend(ColorImage& image, int x, int y, const Ink& ink, float cover) noexcept {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  const float alpha = cover * static_cast<float>(ink.alpha) / 255.0F;
  std::uint8_t* pixel = &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                        static_cast<std::size_t>(x))];
  const std::uint8_t channels[] = {ink.red, ink.green, ink.blue};
  for (int i = 0; i < 3; ++i)
    pixel[i] = static_cast<std::uint8_t>(std::lround(
        static_cast<float>(pixel[i]) + alpha * (static_cast<float>(channels[i]) - static_cast<float>(pixel[i]))));
}

void draw_text(ColorImage& image, int x, int y, std::string_view text, const Ink& ink) {
  while (!text.empty()) {
    const Glyph& glyph = glyph_of(next_code(text));
    for (int row = 0; row < kLineHeight_px; ++row)
      for (std::size_t column = 0; column < glyph.rows[static_cast<std::size_t>(row)].size(); ++column)
        blend(image, x + static_cast<int>(column), y + row, ink,
              coverage(glyph.rows[static_cast<std::size_t>(row)][column]));
    x += glyph.advance_px;
  }
}

}  // namespace telepalp::ar
