#include "clients/ar/shadow_map.h"

#include <Eigen/Geometry>
#include <limits>

#include "clients/ar/scan.h"

namespace telepalp::ar {

ShadowMap::ShadowMap(const Eigen::Vector3f& centre, const Eigen::Vector3f& light, float reach_m)
    : centre_(centre),
      px_per_m_(0.5F * kSide / reach_m),
      depth_(std::size_t{kSide} * kSide, std::numeric_limits<float>::infinity()) {
  const Eigen::Vector3f side = light.unitOrthogonal();
  map_from_scene_.row(0) = side.transpose();
  map_from_scene_.row(1) = light.cross(side).transpose();
  map_from_scene_.row(2) = -light.transpose();
}

Eigen::Vector3f ShadowMap::to_map(const Eigen::Vector3f& at) const noexcept {
  const Eigen::Vector3f local = map_from_scene_ * (at - centre_);
  return {0.5F * kSide + local.x() * px_per_m_, 0.5F * kSide + local.y() * px_per_m_, local.z()};
}

void ShadowMap::add(const Mesh& caster) {
  std::vector<Projected> on_map;
  for (const Mesh::Vertex& vertex : caster.vertices) {
    const Eigen::Vector3f at = to_map(vertex.at);
    on_map.push_back({at.x(), at.y(), at.z(), true});
  }
  for (const auto& [ia, ib, ic] : caster.triangles) {
    const Projected &a = on_map[ia], &b = on_map[ib], &c = on_map[ic];
    scan(a, b, c, kSide, kSide, [&](int x, int y, float wa, float wb, float wc) {
      float& nearest = depth_[static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)];
      nearest = std::min(nearest, wa * a.depth + wb * b.depth + wc * c.depth);
    });
  }
}

float ShadowMap::light_at(const Eigen::Vector3f& at) const noexcept {
  constexpr int kSoft_px = 5;
  constexpr int kStep_px = 2;
  constexpr float kBias_m = 0.004F;  // without it, surfaces shadow themselves in stripes
  const Eigen::Vector3f here = to_map(at);
  if (!(here.x() > kSoft_px && here.y() > kSoft_px && here.x() < kSide - 1 - kSoft_px &&
        here.y() < kSide - 1 - kSoft_px))
    return 1.0F;
  int lit = 0, taps = 0;
  for (int dy = -kSoft_px + 1; dy < kSoft_px; dy += kStep_px)
    for (int dx = -kSoft_px + 1; dx < kSoft_px; dx += kStep_px) {
      const auto x = static_cast<std::size_t>(static_cast<int>(here.x()) + dx);
      const auto y = static_cast<std::size_t>(static_cast<int>(here.y()) + dy);
      lit += depth_[y * kSide + x] > here.z() - kBias_m ? 1 : 0;
      ++taps;
    }
  return static_cast<float>(lit) / static_cast<float>(taps);
}

}  // namespace telepalp::ar
