#pragma once

#include <string>
#include <vector>

namespace telepalp::plot {

/// A table of values as coloured cells, each with its value. A darker cell has a larger value. A value that is not
/// finite has a dash on a cell without colour.
struct HeatMap {
  std::string title;
  std::string x_label;  ///< with the unit
  std::string y_label;
  std::vector<std::string> columns;
  std::vector<std::string> rows;  ///< the first is drawn at the top
  std::vector<double> values;     ///< row by row
  double width_px = 720.0;
};

/// The map as a self-contained SVG element. The colours go from white to blue, so that they differ in greyscale, too.
[[nodiscard]] std::string to_svg(const HeatMap& map);

}  // namespace telepalp::plot
