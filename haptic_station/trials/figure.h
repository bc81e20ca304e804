#pragma once

#include <string>
#include <vector>

namespace telepalp::trials {

struct Curve {
  std::string name;
  std::string color;
  std::vector<double> x;
  std::vector<double> y;
};

/// A stretch of the x axis in one phase.
struct Stretch {
  double from;
  double to;
  std::string color;
};

/// One plot: curves over shared axes, stretches behind them.
struct Figure {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  std::vector<Stretch> stretches;
};

/// As an SVG element of 900 by 260 pixels. Samples that are not finite are left out.
[[nodiscard]] std::string to_svg(const Figure& figure);

}  // namespace telepalp::trials
