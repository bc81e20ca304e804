#include "haptic_station/station/rigs/placement.h"

#include <algorithm>
#include <vector>

#include "proto/words/numbers/quantile.h"

namespace telepalp::station {
namespace {

constexpr int kSmallestHalf_px = 4;

/// The measured samples of the centred window of half side `half`.
std::vector<std::uint16_t> measured(const DepthImage& depth, int half) {
  std::vector<std::uint16_t> samples;
  for (int row = depth.height / 2 - half; row < depth.height / 2 + half; ++row)
    for (int column = depth.width / 2 - half; column < depth.width / 2 + half; ++column)
      if (const std::uint16_t sample = depth.at(column, row); sample != 0) samples.push_back(sample);
  return samples;
}

}  // namespace

std::optional<Point<DepthCamera>> point_under_center(const DepthImage& depth, const Intrinsics& camera) {
  const int largest = std::min(depth.width, depth.height) / 2;
  for (int half = std::min(kSmallestHalf_px, largest); half > 0 && half <= largest; half *= 2) {
    std::vector<std::uint16_t> samples = measured(depth, half);
    if (samples.size() < 2 * static_cast<std::size_t>(half) * static_cast<std::size_t>(half)) continue;
    const double z_m = median_of(samples) * depth.unit_m;
    const int column = depth.width / 2;
    const int row = depth.height / 2;
    return Point<DepthCamera>{{(column - camera.cx) / camera.fx * z_m, (row - camera.cy) / camera.fy * z_m, z_m}};
  }
  return std::nullopt;
}

Transform<HapticBase, DepthCamera> centered_on(const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                                               const Point<DepthCamera>& skin) noexcept {
  Transform<HapticBase, DepthCamera> centered = haptic_from_camera;
  centered.iso.translation() -= (haptic_from_camera * skin).m;
  return centered;
}

std::optional<Transform<HapticBase, DepthCamera>> placed(const scenes::Scene& scene, const DepthImage& depth,
                                                         const Intrinsics& camera) {
  if (!scene.center_on_surface) return scene.haptic_from_camera;
  const std::optional<Point<DepthCamera>> skin = point_under_center(depth, camera);
  if (!skin) return std::nullopt;
  return centered_on(scene.haptic_from_camera, *skin);
}

}  // namespace telepalp::station
