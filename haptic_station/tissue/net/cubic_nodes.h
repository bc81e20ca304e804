#pragma once

#include <array>

namespace telepalp::tissue {

/// Nodes of a cubic on a triangle, in thirds of the barycentric coordinates: corners, two on each edge, the middle.
inline constexpr std::array<std::array<int, 3>, 10> kCubicNodes{
    {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {1, 2, 0}, {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}}};

}  // namespace telepalp::tissue
