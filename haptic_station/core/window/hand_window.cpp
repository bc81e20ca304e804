#include "haptic_station/core/window/hand_window.h"

#include <algorithm>
#include <cmath>

namespace telepalp::core {
namespace {

constexpr double kLeastRadius_m = 0.04;
constexpr double kMostRadius_m = 0.3;
constexpr double kNearest_m = 0.15;  // from the camera; a ball that is nearer has no useful projection
// The surface at a pixel depends on the pixels up to this distance away: 13 with the setting `fast`, 19 with wider
// nodes (surface::SurfaceSettings: node_step_px times support_nodes, and fit_radius_px).
constexpr double kSupport_px = 20.0;

struct Pixel {
  double u = 0.0;
  double v = 0.0;
};

Pixel projected(const Eigen::Vector3d& at, const Intrinsics& camera) noexcept {
  return {.u = camera.fx * at.x() / at.z() + camera.cx, .v = camera.fy * at.y() / at.z() + camera.cy};
}

/// The pixels within `half_width` and `half_height` of `middle` that lie in the image. The height is rounded up to a
/// multiple of four, as far as the image allows.
std::optional<PixelRect> around(const Pixel& middle, double half_width, double half_height, const Intrinsics& camera) {
  const auto first = [](double at, int size) { return static_cast<int>(std::floor(std::clamp(at, -1.0, size + 1.0))); };
  const auto last = [](double at, int size) { return static_cast<int>(std::ceil(std::clamp(at, -1.0, size + 1.0))); };
  const int left = first(middle.u - half_width, camera.width);
  const int top = first(middle.v - half_height, camera.height);
  const int width = last(middle.u + half_width, camera.width) - left + 1;
  const int height = last(middle.v + half_height, camera.height) - top + 1;
  std::optional<PixelRect> rect = clipped({left, top, width, height}, camera.width, camera.height);
  if (!rect || camera.height < 4) return rect;
  rect->height = std::min((rect->height + 3) / 4 * 4, camera.height / 4 * 4);
  rect->row = std::min(rect->row, camera.height - rect->height);
  return rect;
}

}  // namespace

std::optional<PixelRect> hand_window(const MovingHand& hand, Nanoseconds lead, const Intrinsics& camera) {
  if (!is_well_formed(camera) || !hand.device.m.allFinite() || !hand.velocity_m_per_s.allFinite()) return std::nullopt;
  const Eigen::Vector3d way_m = hand.velocity_m_per_s * std::max(0.0, to_seconds(lead));
  const double radius_m = std::min(kMostRadius_m, kLeastRadius_m + way_m.norm());
  const Eigen::Vector3d ahead_m = way_m.norm() > kMostRadius_m ? way_m.normalized() * kMostRadius_m : way_m;
  const Eigen::Vector3d middle = hand.device.m + ahead_m;
  if (middle.z() < kNearest_m) return std::nullopt;
  const double nearest_m = std::max(kNearest_m, middle.z() - radius_m);
  return around(projected(middle, camera), camera.fx * radius_m / nearest_m + kSupport_px,
                camera.fy * radius_m / nearest_m + kSupport_px, camera);
}

bool covers(const PixelRect& exact, const Point<DepthCamera>& device, const Intrinsics& camera) noexcept {
  if (!(device.m.z() >= kNearest_m) || !device.m.allFinite()) return false;
  const Pixel at = projected(device.m, camera);
  // Where the window ends at the image's border, no pixels lie beyond it, with or without a window.
  const bool left = exact.column == 0 || at.u - kSupport_px >= exact.column;
  const bool right = exact.column + exact.width == camera.width || at.u + kSupport_px < exact.column + exact.width;
  const bool top = exact.row == 0 || at.v - kSupport_px >= exact.row;
  const bool bottom = exact.row + exact.height == camera.height || at.v + kSupport_px < exact.row + exact.height;
  return left && right && top && bottom;
}

}  // namespace telepalp::core
