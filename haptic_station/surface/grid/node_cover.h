#pragma once

namespace telepalp::surface {

/// Share of the nodes' full weight around a query below which there is no surface, and share from which its coverage is
/// 1. Between them, the coverage is a smooth step.
inline constexpr double kLeastCover = 0.30;
inline constexpr double kWholeCover = 0.55;

}  // namespace telepalp::surface
