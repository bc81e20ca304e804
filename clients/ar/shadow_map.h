#pragma once

#include <vector>

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// What a distant light sees first, so that the hand casts a shadow on the body: the eye judges height by it.
class ShadowMap {
 public:
  /// Covers `reach_m` around `centre`. `light` is the unit direction towards the light.
  ShadowMap(const Eigen::Vector3f& centre, const Eigen::Vector3f& light, float reach_m);

  /// Adds something that casts a shadow.
  void add(const Mesh& caster);

  /// How much light reaches `at`: 0 in full shadow, 1 in full light; softened at the rim.
  [[nodiscard]] float light_at(const Eigen::Vector3f& at) const noexcept;

 private:
  static constexpr int kSide = 1024;
  [[nodiscard]] Eigen::Vector3f to_map(const Eigen::Vector3f& at) const noexcept;

  Eigen::Vector3f centre_;
  Eigen::Matrix3f map_from_scene_;  ///< rows: two axes of the map, and away from the light
  float px_per_m_;
  std::vector<float> depth_;
};

}  // namespace telepalp::ar
