#pragma once

#include <span>
#include <string>
#include <vector>

namespace telepalp::plot {

/// A closed interval of data or of pixels. For vertical pixels `least` may exceed `most`, because y grows downwards.
struct Range {
  double least = 0.0;
  double most = 1.0;
};

/// The smallest range that contains all finite values; `otherwise` when no value is finite.
[[nodiscard]] Range range_of(std::span<const double> values, Range otherwise);

/// The smallest range that contains both ranges.
[[nodiscard]] Range united(Range a, Range b) noexcept;

/// A tick of an axis: its value and its label.
struct Tick {
  double at = 0.0;
  std::string label;
};

/// About `wanted` ticks within `range`, at the multiples of a step that is 1, 2 or 5 times a power of ten.
/// Source: Heckbert, "Nice numbers for graph labels", Graphics Gems, 1990.
[[nodiscard]] std::vector<Tick> nice_ticks(Range range, int wanted);

/// Ticks at the powers of ten within `range` (both ends > 0).
[[nodiscard]] std::vector<Tick> decade_ticks(Range range);

/// Maps data to pixels on a linear or logarithmic scale. On a logarithmic scale, values <= 0 give NaN.
struct Scale {
  Range data;
  Range pixels;
  bool logarithmic = false;

  [[nodiscard]] double operator()(double value) const noexcept;
};

}  // namespace telepalp::plot
