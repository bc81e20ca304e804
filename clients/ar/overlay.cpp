#include "clients/ar/overlay.h"

#include <algorithm>
#include <cmath>

namespace telepalp::ar {
namespace {

constexpr int kMargin = 24, kPadding = 16, kSwatch = 18, kGap = 28, kLineSpacing = 5;
constexpr images::Ink kBackground{18, 24, 33, 196};
constexpr images::Ink kName{176, 188, 202, 255};
constexpr images::Ink kValue{255, 255, 255, 255};

/// A filled rectangle with rounded corners and smooth edges.
void rounded(ColorImage& image, int left, int top, int width, int height, float radius, const images::Ink& ink) {
  const float half_width = 0.5F * static_cast<float>(width), half_height = 0.5F * static_cast<float>(height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float dx = std::abs(static_cast<float>(x) + 0.5F - half_width) - half_width + radius;
      const float dy = std::abs(static_cast<float>(y) + 0.5F - half_height) - half_height + radius;
      const float outside = std::hypot(std::max(dx, 0.0F), std::max(dy, 0.0F)) - radius;
      images::blend(image, left + x, top + y, ink, std::clamp(0.5F - outside, 0.0F, 1.0F));
    }
}

int name_indent(const PanelLine& line) { return line.swatch ? kSwatch + 12 : 0; }

}  // namespace

void draw_panel(ColorImage& image, Corner corner, const std::vector<PanelLine>& lines) {
  if (lines.empty()) return;
  int names = 0, values = 0;
  for (const PanelLine& line : lines) {
    names = std::max(names, name_indent(line) + images::text_width_px(line.name));
    values = std::max(values, images::text_width_px(line.value));
  }
  const int row = images::kFullLine_px + kLineSpacing;
  const int width = 2 * kPadding + names + (values > 0 ? kGap + values : 0);
  const int height = 2 * kPadding + row * static_cast<int>(lines.size()) - kLineSpacing;
  const bool right = corner == Corner::TopRight || corner == Corner::BottomRight;
  const bool bottom = corner == Corner::BottomLeft || corner == Corner::BottomRight;
  const int left = right ? image.width - kMargin - width : kMargin;
  const int top = bottom ? image.height - kMargin - height : kMargin;
  rounded(image, left, top, width, height, 12.0F, kBackground);
  int y = top + kPadding;
  for (const PanelLine& line : lines) {
    if (line.swatch) rounded(image, left + kPadding, y + 4, kSwatch, kSwatch, 9.0F, *line.swatch);
    images::draw_text(image, left + kPadding + name_indent(line), y, line.name, line.value.empty() ? kValue : kName);
    images::draw_text(image, left + width - kPadding - images::text_width_px(line.value), y, line.value, kValue);
    y += row;
  }
}

}  // namespace telepalp::ar
