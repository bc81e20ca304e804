#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace telepalp::plot {

/// Which samples of a curve to keep, in order, so that it looks the same when drawn `columns` wide: of every run of
/// samples that share a column, the first, the least, the greatest and the last. No peak is ever lost.
/// `x` ascends; `y` has its length. Non-finite samples: one of each gap is kept, so that the curve still breaks there.
[[nodiscard]] std::vector<std::size_t> thin_keeping_extremes(std::span<const double> x, std::span<const double> y,
                                                             std::size_t columns);

/// Which samples of a path in the plane to keep so that no dropped one lies further than about `distance` from a kept
/// one. For curves that are no function of x, e.g. force over indentation. Gaps as above.
[[nodiscard]] std::vector<std::size_t> thin_path(std::span<const double> x, std::span<const double> y, double distance);

}  // namespace telepalp::plot
