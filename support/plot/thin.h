#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace telepalp::plot {

/// Indices of the samples that suffice to draw a curve `columns` pixels wide: of the samples in one pixel column the
/// first, those with the least and the greatest y, and the last, so that no peak is lost. `x` ascends and has the
/// length of `y`. Of consecutive non-finite samples one is kept, so that the drawn curve has a gap.
[[nodiscard]] std::vector<std::size_t> thin_keeping_extremes(std::span<const double> x, std::span<const double> y,
                                                             std::size_t columns);

/// Indices of the samples that suffice to draw a path in the plane: each dropped sample is closer than `distance` to a
/// kept one. For curves that are not functions of x, for example force over indentation. Of consecutive non-finite
/// samples one is kept.
[[nodiscard]] std::vector<std::size_t> thin_path(std::span<const double> x, std::span<const double> y, double distance);

}  // namespace telepalp::plot
