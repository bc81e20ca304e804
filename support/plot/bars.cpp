#include "support/plot/bars.h"

#include <cmath>

#include "support/plot/ink.h"
#include "support/plot/number.h"
#include "support/plot/scale.h"
#include "support/plot/svg.h"

namespace telepalp::plot {
namespace {

constexpr double kNames = 200.0, kNumbers = 190.0, kBarTop = 30.0, kBarRow = 30.0, kBarAxis = 44.0;

Scale scale_of(const BarChart& chart) {
  std::vector<double> values{0.0};
  for (const Bar& bar : chart.bars) values.insert(values.end(), {bar.typical, bar.rare});
  Range range = range_of(values, {0.0, 1.0});
  if (range.most <= 0.0) range.most = 1.0;
  return {{0.0, range.most}, {kNames, chart.width_px - kNumbers}};
}

void draw_bar(Svg& svg, const BarChart& chart, const Bar& bar, const Scale& scale, double middle) {
  svg.text({kNames - 10.0, middle + 4.0}, bar.name, Anchor::End, kTextSize, kInk);
  const double numbers_at = chart.width_px - kNumbers + 12.0;
  if (!std::isfinite(bar.typical) || !std::isfinite(bar.rare)) {
    svg.text({numbers_at, middle + 4.0}, "not measured", Anchor::Start, kTextSize, kInk);
    return;
  }
  svg.rect({scale(0.0), middle - 9.0}, {scale(bar.typical), middle + 9.0}, bar.color);
  svg.line({scale(bar.typical), middle}, {scale(bar.rare), middle}, kInk, 1.4);
  svg.line({scale(bar.rare), middle - 6.0}, {scale(bar.rare), middle + 6.0}, kInk, 1.4);
  svg.text({numbers_at, middle + 4.0},
           "p50 " + readable(bar.typical) + "   p99 " + readable(bar.rare) + " " + chart.unit, Anchor::Start, kTextSize,
           kInk);
}

}  // namespace

std::string to_svg(const BarChart& chart) {
  const double bottom = kBarTop + kBarRow * static_cast<double>(chart.bars.size());
  const Scale scale = scale_of(chart);
  Svg svg(chart.width_px, bottom + kBarAxis, chart.title);
  svg.text({66.0, 15.0}, chart.title, Anchor::Start, 14.0, kInk, true);
  for (const Tick& tick : nice_ticks(scale.data, 6)) {
    svg.line({scale(tick.at), kBarTop}, {scale(tick.at), bottom}, kFaint, 1.0);
    svg.text({scale(tick.at), bottom + 16.0}, tick.label, Anchor::Middle, kTextSize, kInk);
  }
  for (std::size_t i = 0; i < chart.bars.size(); ++i)
    draw_bar(svg, chart, chart.bars[i], scale, kBarTop + kBarRow * (static_cast<double>(i) + 0.5));
  svg.line({scale(0.0), kBarTop}, {scale(0.0), bottom}, kInk, 1.0);
  svg.text({(scale.pixels.least + scale.pixels.most) / 2.0, bottom + 34.0}, "[" + chart.unit + "]", Anchor::Middle,
           kTextSize, kInk);
  return std::move(svg).finish();
}

}  // namespace telepalp::plot
