#include "support/plot/chart.h"

#include <algorithm>
#include <cmath>

#include "proto/words/demand.h"
#include "support/plot/ink.h"
#include "support/plot/number.h"
#include "support/plot/svg.h"
#include "support/plot/thin.h"

namespace telepalp::plot {
namespace {

constexpr double kChartLeft = 66.0, kChartRight = 16.0, kChartTitle = 24.0, kLegendRow = 18.0, kChartBottom = 44.0;

struct LegendEntry {
  std::string name;
  std::string color;
  bool band = false;
  bool dashed = false;
};

std::vector<LegendEntry> legend_of(const Chart& chart) {
  std::vector<LegendEntry> entries;
  const auto add = [&](const LegendEntry& entry) {
    const bool known = std::any_of(entries.begin(), entries.end(), [&](const auto& e) { return e.name == entry.name; });
    if (!entry.name.empty() && !known) entries.push_back(entry);
  };
  for (const Series& series : chart.series) add({series.name, series.color, false, series.style == Style::Dashed});
  for (const Band& band : chart.bands) add({band.name, band.color, true, false});
  return entries;
}

/// Estimated width of `text` [px], without font metrics: from an average letter width that is rather too large.
double width_of(std::string_view text, double size) { return 0.6 * size * static_cast<double>(text.size()); }

double entry_width(const LegendEntry& entry) { return 24.0 + width_of(entry.name, kTextSize) + 14.0; }

/// Places legend entries in rows; calls `place(entry, x, row)`; returns the number of rows.
template <class Place>
int lay_out_legend(const Chart& chart, Place place) {
  double x = kChartLeft;
  int row = 0;
  const std::vector<LegendEntry> entries = legend_of(chart);
  for (const LegendEntry& entry : entries) {
    if (x > kChartLeft && x + entry_width(entry) > chart.width_px - kChartRight) {
      x = kChartLeft;
      ++row;
    }
    place(entry, x, row);
    x += entry_width(entry);
  }
  return entries.empty() ? 0 : row + 1;
}

Range padded(Range range, const Axis& axis) {
  if (axis.include) range = united(range, *axis.include);
  if (axis.logarithmic) {
    range.least = std::max(range.least, 1e-9);
    return {range.least, std::max(range.most, range.least * 10.0)};
  }
  if (range.most - range.least <= 1e-12 * std::max(1.0, std::abs(range.most)))
    return {range.least - 0.5, range.most + 0.5};
  return range;
}

Range data_range(const Chart& chart, bool vertical) {
  std::vector<double> finite;
  const bool logarithmic = vertical ? chart.y.logarithmic : chart.x.logarithmic;
  for (const Series& series : chart.series)
    for (const double value : vertical ? series.y : series.x)
      if (std::isfinite(value) && (!logarithmic || value > 0.0)) finite.push_back(value);
  for (const Rule& rule : chart.rules)
    if (rule.vertical != vertical) finite.push_back(rule.at);
  if (!vertical)
    for (const Band& band : chart.bands) finite.insert(finite.end(), {band.from, band.to});
  Range range = padded(range_of(finite, {logarithmic ? 1.0 : 0.0, 1.0}), vertical ? chart.y : chart.x);
  if (vertical && !logarithmic) {  // space above the data, so that a curve does not run along the frame
    const double room = 0.04 * (range.most - range.least);
    range = {range.least - room, range.most + room};
  }
  return range;
}

struct Scales {
  Scale x, y;
};

Scales scales_of(const Chart& chart) {
  const Frame frame = frame_of(chart);
  return {{data_range(chart, false), frame.x_px, chart.x.logarithmic},
          {data_range(chart, true), frame.y_px, chart.y.logarithmic}};
}

std::vector<Tick> ticks_of(const Axis& axis, const Scale& scale, double px_for_each) {
  if (!axis.ticks.empty()) return axis.ticks;
  if (axis.logarithmic) return decade_ticks(scale.data);
  const double room = std::abs(scale.pixels.most - scale.pixels.least);
  return nice_ticks(scale.data, std::max(2, static_cast<int>(room / px_for_each)));
}

void draw_axes(Svg& svg, const Chart& chart, const Scales& scales) {
  const auto [left, right] = scales.x.pixels;
  const auto [bottom, top] = scales.y.pixels;
  for (const Tick& tick : ticks_of(chart.y, scales.y, 45.0)) {
    const double y = scales.y(tick.at);
    svg.line({left, y}, {right, y}, kFaint, 1.0);
    svg.text({left - 8.0, y + 4.0}, tick.label, Anchor::End, kTextSize, kInk);
  }
  for (const Tick& tick : ticks_of(chart.x, scales.x, 90.0)) {
    const double x = scales.x(tick.at);
    svg.line({x, bottom}, {x, bottom + 5.0}, kInk, 1.0);
    svg.text({x, bottom + 18.0}, tick.label, Anchor::Middle, kTextSize, kInk);
  }
  svg.path({{left, top}, {left, bottom}, {right, bottom}}, kInk, 1.0);
  svg.text({(left + right) / 2.0, bottom + 36.0}, chart.x.label, Anchor::Middle, kTextSize, kInk);
  svg.text({16.0, (top + bottom) / 2.0}, chart.y.label, Anchor::Middle, kTextSize, kInk, false, false);
}

void draw_bands(Svg& svg, const Chart& chart, const Scales& scales) {
  const auto [bottom, top] = scales.y.pixels;
  for (const Band& band : chart.bands) {
    const double from = scales.x(band.from), to = scales.x(band.to);
    svg.rect({from, top}, {to, bottom}, band.color, 0.16);
    if (to - from >= width_of(band.mark, 10.0) + 2.0)
      svg.text({(from + to) / 2.0, top + 11.0}, band.mark, Anchor::Middle, 10.0, kInk);
  }
}

std::vector<Pixel> stepped(const std::vector<Pixel>& points) {
  std::vector<Pixel> out;
  for (const Pixel& point : points) {
    if (!out.empty() && std::isfinite(out.back().y)) out.push_back({point.x, out.back().y});
    out.push_back(point);
  }
  return out;
}

std::vector<Pixel> thinned(const Series& series, const Scales& scales) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    x.push_back(scales.x(series.x[i]));
    y.push_back(scales.y(series.y[i]));
  }
  const bool in_the_plane = series.style == Style::Path || series.style == Style::Dots;
  const double columns = std::abs(scales.x.pixels.most - scales.x.pixels.least);
  const auto kept =
      in_the_plane ? thin_path(x, y, 0.7) : thin_keeping_extremes(x, y, static_cast<std::size_t>(columns) + 1);
  std::vector<Pixel> points;
  points.reserve(kept.size());
  for (const std::size_t i : kept) points.push_back({x[i], y[i]});
  return points;
}

void draw_series(Svg& svg, const Series& series, const Scales& scales) {
  demand(series.x.size() == series.y.size(), "a series has as many x values as y values");
  const std::vector<Pixel> points = thinned(series, scales);
  if (series.style == Style::Dots) {
    for (const Pixel& point : points) svg.disc(point, 2.0, series.color);
  } else if (series.style == Style::Area && !points.empty()) {
    std::vector<Pixel> outline = stepped(points);
    outline.insert(outline.begin(), {outline.front().x, scales.y.pixels.least});
    outline.push_back({outline.back().x, scales.y.pixels.least});
    svg.polygon(outline, series.color, 0.75);
  } else {
    svg.path(series.style == Style::Step ? stepped(points) : points, series.color, 1.6,
             series.style == Style::Dashed ? "5 4" : "");
  }
}

void draw_rule(Svg& svg, const Rule& rule, const Scales& scales) {
  if (rule.vertical) {
    const double x = scales.x(rule.at), top = scales.y.pixels.most;
    svg.line({x, scales.y.pixels.least}, {x, top}, rule.color, 1.6, "7 4");
    const bool right_half = x > (scales.x.pixels.least + scales.x.pixels.most) / 2.0;
    svg.text({x + (right_half ? -6.0 : 6.0), top + 13.0}, rule.label, right_half ? Anchor::End : Anchor::Start,
             kTextSize, rule.color, true);
  } else {
    const double y = scales.y(rule.at);
    svg.line({scales.x.pixels.least, y}, {scales.x.pixels.most, y}, rule.color, 1.6, "7 4");
    svg.text({scales.x.pixels.most - 4.0, y - 5.0}, rule.label, Anchor::End, kTextSize, rule.color, true);
  }
}

void draw_mark(Svg& svg, const Mark& mark, const Scales& scales) {
  const Pixel at{scales.x(mark.x), scales.y(mark.y)};
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;
  svg.disc(at, 3.5, mark.color);
  const bool right = at.x + 8.0 + width_of(mark.name, kTextSize) > scales.x.pixels.most;
  svg.text({at.x + (right ? -7.0 : 7.0), at.y - 5.0}, mark.name, right ? Anchor::End : Anchor::Start, kTextSize,
           mark.color);
}

void draw_legend(Svg& svg, const Chart& chart) {
  lay_out_legend(chart, [&](const LegendEntry& entry, double x, int row) {
    const double y = kChartTitle + kLegendRow * row + 9.0;
    if (entry.band)
      svg.rect({x, y - 5.0}, {x + 18.0, y + 5.0}, entry.color, 0.3);
    else
      svg.line({x, y}, {x + 18.0, y}, entry.color, 2.4, entry.dashed ? "5 4" : "");
    svg.text({x + 24.0, y + 4.0}, entry.name, Anchor::Start, kTextSize, kInk);
  });
}

}  // namespace

Frame frame_of(const Chart& chart) noexcept {
  const int rows = lay_out_legend(chart, [](const LegendEntry&, double, int) {});
  return {{kChartLeft, chart.width_px - kChartRight},
          {chart.height_px - kChartBottom, kChartTitle + kLegendRow * rows + 8.0}};
}

std::string to_svg(const Chart& chart) {
  const Scales scales = scales_of(chart);
  Svg svg(chart.width_px, chart.height_px, chart.title);
  svg.text({kChartLeft, 15.0}, chart.title, Anchor::Start, 14.0, kInk, true);
  draw_bands(svg, chart, scales);
  draw_axes(svg, chart, scales);
  for (const Series& series : chart.series) draw_series(svg, series, scales);
  for (const Rule& rule : chart.rules) draw_rule(svg, rule, scales);
  for (const Mark& mark : chart.marks) draw_mark(svg, mark, scales);
  draw_legend(svg, chart);
  return std::move(svg).finish();
}

std::string to_svg(std::span<const Chart> charts) {
  std::string svg;
  for (const Chart& chart : charts) svg += to_svg(chart);
  return svg;
}

std::string to_svg_document(std::span<const Chart> charts) {
  std::string svg;
  double top_px = 0.0;
  for (const Chart& chart : charts) {
    svg += "<svg y=\"" + number(top_px) + "\" width=\"" + number(chart.width_px) + "\" height=\"" +
           number(chart.height_px) + "\">\n" + to_svg(chart) + "</svg>\n";
    top_px += chart.height_px;
  }
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(charts.front().width_px) + "\" height=\"" +
         number(top_px) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" + svg + "</svg>\n";
}

}  // namespace telepalp::plot
