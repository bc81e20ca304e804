#include "server/capture/synthetic/sensor/holes.h"

#include <algorithm>
#include <cmath>

namespace telepalp::capture {
namespace {

constexpr float kProjectorToTheRight_m = 0.075F;
constexpr float kJump_m = 0.012F;          // depth step between neighbouring pixels at a silhouette
constexpr int kRaggedReach_px = 2;         // the correlation window straddles the silhouette this far
constexpr float kGrazingSlope_m = 0.005F;  // depth change a pixel: rays within about 17 degrees of the skin at 0.8 m
constexpr std::uint8_t kAlways = 255;

/// Marks the pixels that the projector cannot light. Along a row from right to left, away from the projector, the
/// column in which the projector sees the points must decrease: a point in a larger column than an earlier point lies
/// in the earlier point's shadow.
void mark_shadow(const float* depth_m, int width, float fx, std::uint8_t* hole) {
  float reached = static_cast<float>(width) * 2.0F;
  for (int u = width - 1; u >= 0; --u) {
    const float seen_from_projector_px = static_cast<float>(u) - fx * kProjectorToTheRight_m / depth_m[u];
    if (seen_from_projector_px > reached) hole[u] = kAlways;
    reached = std::min(reached, seen_from_projector_px);
  }
}

void raise(std::uint8_t& hole, int by) { hole = std::max(hole, static_cast<std::uint8_t>(by)); }

}  // namespace

std::vector<std::uint8_t> hole_map(const std::vector<float>& depth_m, const Intrinsics& camera) {
  const int width = camera.width;
  const int height = camera.height;
  const auto index = [width](int u, int v) {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  };
  std::vector<std::uint8_t> hole(depth_m.size(), 0);
  for (int v = 0; v < height; ++v)
    mark_shadow(&depth_m[index(0, v)], width, static_cast<float>(camera.fx), &hole[index(0, v)]);
  for (int v = 1; v < height; ++v)
    for (int u = 1; u < width; ++u) {
      const float jump = std::max(std::abs(depth_m[index(u, v)] - depth_m[index(u - 1, v)]),
                                  std::abs(depth_m[index(u, v)] - depth_m[index(u, v - 1)]));
      if (jump > kGrazingSlope_m) raise(hole[index(u, v)], 100);
      if (jump <= kJump_m) continue;
      for (int y = std::max(v - kRaggedReach_px, 0); y <= std::min(v + kRaggedReach_px, height - 1); ++y)
        for (int x = std::max(u - kRaggedReach_px, 0); x <= std::min(u + kRaggedReach_px, width - 1); ++x)
          raise(hole[index(x, y)], 220 - 50 * std::max(std::abs(x - u), std::abs(y - v)));
    }
  return hole;
}

}  // namespace telepalp::capture
