#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace telepalp::surface {

struct Neighbor {
  std::uint32_t index = 0;
  float squared_m2 = 0.0F;  ///< squared distance from the query
};

inline constexpr float kAnywhere_m = 1e6F;  ///< a radius within which all points of a cloud lie

/// Interface of every index for neighbour queries over 3-D points. Immutable after construction.
class NeighborIndex {
 public:
  /// Writes the points within `radius_m` of `query` to `found`, unordered. If `found` is too short for all of them, the
  /// nearest ones are written. Returns the number of points written.
  [[nodiscard]] virtual std::size_t within(const Eigen::Vector3f& query, float radius_m,
                                           std::span<Neighbor> found) const noexcept = 0;
  [[nodiscard]] virtual const char* name() const noexcept = 0;
  /// True when within() never allocates, locks or throws.
  [[nodiscard]] virtual bool realtime_safe() const noexcept = 0;

 protected:
  ~NeighborIndex() = default;  // protected: objects are never deleted through this type
};

}  // namespace telepalp::surface
