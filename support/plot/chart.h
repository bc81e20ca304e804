#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/plot/scale.h"

namespace telepalp::plot {

/// One axis. The range always covers the data; `include` asks for more, e.g. a budget that no value reached.
struct Axis {
  std::string label;  ///< with its unit, "force [N]"
  std::optional<Range> include = std::nullopt;
  bool logarithmic = false;
  std::vector<Tick> ticks = {};  ///< empty: at nice numbers
};

enum class Style {
  Line,    ///< x ascends; thinned by column, extremes kept
  Dashed,  ///< the same, dashed
  Step,    ///< the same, each value held until the next
  Path,    ///< any curve in the plane; thinned by distance
  Area,    ///< a step curve, filled down to the axis
  Dots     ///< one disc for each sample, thinned by distance
};

/// A curve; non-finite samples are gaps. `x` and `y` have equal length.
struct Series {
  std::string name;  ///< for the legend; empty: not in it
  std::vector<double> x;
  std::vector<double> y;
  std::string color;
  Style style = Style::Line;
};

/// A stretch of the x axis that stands out, e.g. a state of the controller.
struct Band {
  double from = 0.0;
  double to = 0.0;
  std::string color;
  std::string name;  ///< for the legend: once for each name
  std::string mark;  ///< short, drawn on top of the band where it fits, so that colour is not needed to read it
};

/// A line across the plot, e.g. a budget.
struct Rule {
  double at = 0.0;
  std::string label;
  std::string color;
  bool vertical = false;
};

/// A point that stands out and is named on the plot.
struct Mark {
  double x = 0.0;
  double y = 0.0;
  std::string name;
  std::string color;
};

/// A chart as a value.
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

/// The frame that the curves are drawn in; its left and right edges depend on the width alone, so that charts of equal
/// width that stand below each other share their time axis.
struct Frame {
  Range x_px;
  Range y_px;  ///< `least` is the bottom
};
[[nodiscard]] Frame frame_of(const Chart& chart) noexcept;

/// The chart as a self-contained SVG element. Every drawn sample lies within the frame.
[[nodiscard]] std::string to_svg(const Chart& chart);

}  // namespace telepalp::plot
