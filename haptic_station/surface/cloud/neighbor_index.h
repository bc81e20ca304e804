#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace telepalp::surface {

struct Neighbor {
  std::uint32_t index = 0;
  float squared_m2 = 0.0F;
};

/// The one concept behind every index over points in space. Immutable once built.
class NeighborIndex {
 public:
  /// Writes the points within `radius_m` of `query` to `found`, in no order; when more than fit, the nearest. How many.
  [[nodiscard]] virtual std::size_t within(const Eigen::Vector3f& query, float radius_m,
                                           std::span<Neighbor> found) const noexcept = 0;
  [[nodiscard]] virtual const char* name() const noexcept = 0;
  /// Whether within() keeps to the real-time rules.
  [[nodiscard]] virtual bool realtime_safe() const noexcept = 0;

 protected:
  ~NeighborIndex() = default;  // never destroyed through this type
};

}  // namespace telepalp::surface
