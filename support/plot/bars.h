#pragma once

#include <string>
#include <vector>

namespace telepalp::plot {

/// One bar of a chart: `typical` (p50) is the bar's length, `rare` (p99) the end of its whisker.
struct Bar {
  std::string name;
  double typical = 0.0;
  double rare = 0.0;
  std::string color;
};

/// Horizontal bars on a common scale that starts at zero; p50 and p99 are printed beside each bar.
struct BarChart {
  std::string title;
  std::string unit;  ///< "ms"
  std::vector<Bar> bars;
  double width_px = 960.0;
};

/// The chart as a self-contained SVG element. A value that is not finite gives no bar but the text "not measured".
[[nodiscard]] std::string to_svg(const BarChart& chart);

}  // namespace telepalp::plot
