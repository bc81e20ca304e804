#pragma once

#include <vector>

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// A shadow map of a distant light. The hand's shadow on the body shows the height of the hand.
class ShadowMap {
 public:
  /// The map covers `reach_m` to each side of `centre`. `light`: unit direction towards the light.
  ShadowMap(const Eigen::Vector3f& centre, const Eigen::Vector3f& light, float reach_m);

  /// Adds a mesh that casts a shadow.
  void add(const Mesh& caster);

  /// Share of the light that reaches `at`: 0 in full shadow, 1 in full light or outside the map, between at the rim.
  [[nodiscard]] float light_at(const Eigen::Vector3f& at) const noexcept;

 private:
  static constexpr int kSide = 1024;
  [[nodiscard]] Eigen::Vector3f to_map(const Eigen::Vector3f& at) const noexcept;

  Eigen::Vector3f centre_;
  Eigen::Matrix3f map_from_scene_;  ///< rows: the two axes of the map, and the direction away from the light
  float px_per_m_;
  std::vector<float> depth_;
};

}  // namespace telepalp::ar
