#include "support/plot/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "support/plot/ink.h"
#include "support/plot/number.h"
#include "support/plot/scale.h"
#include "support/plot/svg.h"

namespace telepalp::plot {
namespace {

constexpr std::string_view kPaper = "#ffffff";
constexpr double kMapLeft = 90.0, kMapTop = 34.0, kMapRow = 34.0, kMapAxis = 52.0;
constexpr std::array kLight{247.0, 251.0, 255.0};
constexpr std::array kDark{8.0, 48.0, 107.0};
constexpr double kInkUntil = 0.55;  // darker cells have white numbers

double share_of(double value, const Range& range) {
  return range.most > range.least ? (value - range.least) / (range.most - range.least) : 0.0;
}

std::string color_at(double share) {
  std::array<char, 8> text{};
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < rgb.size(); ++i)
    rgb[i] = static_cast<int>(std::lround(kLight[i] + share * (kDark[i] - kLight[i])));
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", rgb[0] & 0xff, rgb[1] & 0xff, rgb[2] & 0xff);
  return text.data();
}

Range range_of_finite(const std::vector<double>& values) {
  Range range{0.0, 0.0};
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range = any ? Range{std::min(range.least, value), std::max(range.most, value)} : Range{value, value};
    any = true;
  }
  return range;
}

}  // namespace

std::string to_svg(const HeatMap& map) {
  const auto columns = static_cast<double>(std::max<std::size_t>(1, map.columns.size()));
  const double cell = (map.width_px - kMapLeft - 10.0) / columns;
  const double bottom = kMapTop + kMapRow * static_cast<double>(map.rows.size());
  const Range range = range_of_finite(map.values);
  Svg svg(map.width_px, bottom + kMapAxis, map.title);
  svg.text({kMapLeft, 18.0}, map.title, Anchor::Start, 14.0, kInk, true);
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    const double top = kMapTop + kMapRow * static_cast<double>(row);
    svg.text({kMapLeft - 8.0, top + kMapRow / 2.0 + 4.0}, map.rows[row], Anchor::End, kTextSize, kInk);
    for (std::size_t column = 0; column < map.columns.size(); ++column) {
      const double value = map.values[row * map.columns.size() + column];
      const double left = kMapLeft + cell * static_cast<double>(column);
      const double share = std::isfinite(value) ? share_of(value, range) : 0.0;
      if (std::isfinite(value)) svg.rect({left, top}, {left + cell - 1.0, top + kMapRow - 1.0}, color_at(share));
      svg.text({left + cell / 2.0, top + kMapRow / 2.0 + 4.0}, readable(value), Anchor::Middle, kTextSize,
               share > kInkUntil ? kPaper : kInk);
    }
  }
  for (std::size_t column = 0; column < map.columns.size(); ++column)
    svg.text({kMapLeft + cell * (static_cast<double>(column) + 0.5), bottom + 16.0}, map.columns[column],
             Anchor::Middle, kTextSize, kInk);
  svg.text({kMapLeft + cell * columns / 2.0, bottom + 38.0}, map.x_label, Anchor::Middle, kTextSize, kInk);
  svg.text({16.0, (kMapTop + bottom) / 2.0}, map.y_label, Anchor::Middle, kTextSize, kInk, false, false);
  return std::move(svg).finish();
}

}  // namespace telepalp::plot
