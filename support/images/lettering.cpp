#include "support/images/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace telepalp::images {
namespace {

struct Glyph {
  std::uint32_t code;
  int advance_px;
  std::array<std::string_view, kFullLine_px> rows;  ///< one hexadecimal digit per pixel: its coverage
};

#include "support/images/font/font_data.inc"
static_assert(kLineHeight_px == kFullLine_px);

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

int advance_px(const Glyph& glyph, int line_px) noexcept {
  return (glyph.advance_px * line_px + kFullLine_px / 2) / kFullLine_px;
}

/// Coverage of a pixel of the font; 0 beside the glyph.
float coverage(const Glyph& glyph, int column, int row) noexcept {
  const std::string_view digits = glyph.rows[static_cast<std::size_t>(row)];
  if (static_cast<std::size_t>(column) >= digits.size()) return 0.0F;
  const char digit = digits[static_cast<std::size_t>(column)];
  return static_cast<float>(digit <= '9' ? digit - '0' : digit - 'a' + 10) / 15.0F;
}

/// Mean coverage of a pixel of a line `line_px` high. Lengths are in units of 1 / line_px of the font's pixel, in which
/// this pixel is kFullLine_px wide and the font's pixel is line_px wide.
float coverage(const Glyph& glyph, int x, int y, int line_px) noexcept {
  if (line_px == kFullLine_px) return coverage(glyph, x, y);
  const auto shared = [line_px](int ours, int theirs) {
    return std::min((ours + 1) * kFullLine_px, (theirs + 1) * line_px) -
           std::max(ours * kFullLine_px, theirs * line_px);
  };
  float sum = 0.0F;
  for (int row = y * kFullLine_px / line_px; row < kFullLine_px && shared(y, row) > 0; ++row)
    for (int column = x * kFullLine_px / line_px; shared(x, column) > 0; ++column)
      sum += static_cast<float>(shared(y, row) * shared(x, column)) * coverage(glyph, column, row);
  return sum / static_cast<float>(kFullLine_px * kFullLine_px);
}

void draw(ColorImage& image, int left, int top, const Glyph& glyph, const Ink& ink, int line_px) noexcept {
  std::size_t widest = 0;
  for (const std::string_view row : glyph.rows) widest = std::max(widest, row.size());
  const int width_px = (static_cast<int>(widest) * line_px + kFullLine_px - 1) / kFullLine_px;
  for (int y = 0; y < line_px; ++y)
    for (int x = 0; x < width_px; ++x) blend(image, left + x, top + y, ink, coverage(glyph, x, y, line_px));
}

/// Bytes of the longest beginning of `text` that is at most `width_px` wide; at least one letter.
std::size_t fitting_bytes(std::string_view text, int width_px, int line_px) noexcept {
  std::string_view rest = text;
  for (int width = 0; !rest.empty();) {
    const std::size_t bytes = text.size() - rest.size();
    width += advance_px(glyph_of(next_code(rest)), line_px);
    if (width > width_px && bytes > 0) return bytes;
  }
  return text.size();
}

}  // namespace

void fill(ColorImage& image, const Rectangle& where, const Rgb& rgb) {
  for (int y = std::max(where.y, 0); y < std::min(where.y + where.height, image.height); ++y)
    for (int x = std::max(where.x, 0); x < std::min(where.x + where.width, image.width); ++x)
      std::ranges::copy(rgb, image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x));
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

int text_width_px(std::string_view text, int line_px) noexcept {
  int width = 0;
  while (!text.empty()) width += advance_px(glyph_of(next_code(text)), line_px);
  return width;
}

void draw_text(ColorImage& image, int x, int y, std::string_view text, const Ink& ink, int line_px) {
  while (!text.empty()) {
    const Glyph& glyph = glyph_of(next_code(text));
    draw(image, x, y, glyph, ink, line_px);
    x += advance_px(glyph, line_px);
  }
}

std::vector<std::string> lines_of(std::string_view text, int width_px, int line_px) {
  std::vector<std::string> lines;
  for (std::size_t fits = 0; (fits = fitting_bytes(text, width_px, line_px)) < text.size();) {
    const std::size_t space = text.substr(0, fits + 1).rfind(' ');
    const bool broken = space == std::string_view::npos || space == 0;
    lines.emplace_back(text.substr(0, broken ? fits : space));
    text.remove_prefix(broken ? fits : space + 1);
  }
  lines.emplace_back(text);
  return lines;
}

}  // namespace telepalp::images
