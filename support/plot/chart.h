#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/plot/scale.h"

namespace telepalp::plot {

/// One axis. Its range covers the data and `include`, for example a budget that no value reached.
struct Axis {
  std::string label;  ///< with the unit: "force [N]"
  std::optional<Range> include = std::nullopt;
  bool logarithmic = false;
  std::vector<Tick> ticks = {};  ///< empty: ticks at round numbers
};

enum class Style {
  Line,    ///< x ascends; thinned per pixel column, extremes kept
  Dashed,  ///< like Line, dashed
  Step,    ///< like Line, each value held until the next
  Path,    ///< any curve in the plane; thinned by distance
  Area,    ///< a step curve, filled down to the axis
  Dots     ///< discs at the samples, thinned by distance
};

/// A curve; non-finite samples are gaps. `x` and `y` have equal length.
struct Series {
  std::string name;  ///< in the legend; empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;
  std::string color;
  Style style = Style::Line;
};

/// A highlighted interval of the x axis, for example one state of the controller.
struct Band {
  double from = 0.0;
  double to = 0.0;
  std::string color;
  std::string name;  ///< in the legend, once for each name
  std::string mark;  ///< short text in the band if it fits, so that the chart can be read without colour
};

/// A line across the plot at y = `at`, or at x = `at` if `vertical`, for example a budget.
struct Rule {
  double at = 0.0;
  std::string label;
  std::string color;
  bool vertical = false;
};

/// A highlighted point with a name on the plot.
struct Mark {
  double x = 0.0;
  double y = 0.0;
  std::string name;
  std::string color;
};

/// A chart: curves, bands, lines and marks over two axes.
struct Chart {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series = {};
  std::vector<Band> bands = {};
  std::vector<Rule> rules = {};
  std::vector<Mark> marks = {};
  double width_px = 960.0;
  double height_px = 300.0;
};

/// The rectangle in which the curves are drawn. Its left and right edges in the drawing depend only on the chart's
/// width, so that the time axes of stacked charts of equal width are aligned.
struct Frame {
  Range x_px;
  Range y_px;  ///< `least` is the bottom
};
[[nodiscard]] Frame frame_of(const Chart& chart) noexcept;

/// The chart as a self-contained SVG element. Every drawn sample lies within the frame.
[[nodiscard]] std::string to_svg(const Chart& chart);

/// The charts one below another, as SVG elements for a page.
[[nodiscard]] std::string to_svg(std::span<const Chart> charts);

/// The charts one below another on white, as an SVG document of its own. At least one chart; all of one width.
[[nodiscard]] std::string to_svg_document(std::span<const Chart> charts);

}  // namespace telepalp::plot
