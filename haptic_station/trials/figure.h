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

/// An interval of the x axis with a background colour; it marks one phase of the controller.
struct Stretch {
  double from;
  double to;
  std::string color;
};

/// One plot: curves over shared axes, with coloured intervals behind them.
struct Figure {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  std::vector<Stretch> stretches;
};

/// Draws the figure as an SVG element of 900 × 260 pixels. Samples that are not finite are left out.
[[nodiscard]] std::string to_svg(const Figure& figure);

}  // namespace telepalp::trials
