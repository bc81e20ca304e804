#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/plot/scale.h"

namespace telepalp::plot {

/// A position in the drawing [px]; y grows downwards.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

enum class Anchor { Start, Middle, End };

/// Escapes XML's reserved characters and replaces each control character by a space.
[[nodiscard]] std::string escaped(std::string_view text);

/// Writes an SVG document element by element. Lengths are in pixels; numbers have at most two decimals.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  void line(Pixel from, Pixel to, std::string_view color, double width, std::string_view dashes = {});
  /// Draws a polyline; a point that is not finite interrupts it.
  void path(const std::vector<Pixel>& points, std::string_view color, double width, std::string_view dashes = {});
  void polygon(const std::vector<Pixel>& points, std::string_view fill, double opacity);
  void rect(Pixel corner, Pixel opposite, std::string_view fill, double opacity = 1.0);
  void disc(Pixel centre, double radius, std::string_view fill);
  void text(Pixel at, std::string_view words, Anchor anchor, double size, std::string_view color, bool bold = false,
            bool upright = true);

  [[nodiscard]] std::string finish() &&;

 private:
  std::string out_;
};

}  // namespace telepalp::plot
