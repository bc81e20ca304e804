#pragma once

#include <string>
#include <vector>

namespace telepalp::plot {

/// A typical value as a bar and a rare one as a whisker: p50 and p99 of a stage.
struct Bar {
  std::string name;
  double typical = 0.0;
  double rare = 0.0;
  std::string color;
};

/// Horizontal bars on one scale that starts at zero, each with its two numbers beside it.
struct BarChart {
  std::string title;
  std::string unit;  ///< "ms"
  std::vector<Bar> bars;
  double width_px = 960.0;
};

/// The chart as a self-contained SVG element. A bar whose value is not finite is drawn empty and says so.
[[nodiscard]] std::string to_svg(const BarChart& chart);

}  // namespace telepalp::plot
