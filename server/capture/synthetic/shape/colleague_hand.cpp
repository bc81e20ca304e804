#include "server/capture/synthetic/shape/colleague_hand.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace telepalp::capture {
namespace {

using Eigen::Vector3d;

constexpr double kPalm_m = 0.013;  // radii
constexpr double kFinger_m = 0.008;
constexpr double kThumb_m = 0.009;
constexpr double kWrist_m = 0.026;
constexpr double kElbow_m = 0.038;
constexpr double kKnuckles_m = 0.040;  // from the palm's middle, towards the fingertips
constexpr double kHeel_m = -0.045;
constexpr double kArm_m = 0.7;
constexpr std::array kFingers_m{0.065, 0.075, 0.072, 0.055};  // lengths, from index to little finger
constexpr std::array kAcross_m{-0.030, -0.010, 0.010, 0.030};

/// The hand's own axes in the camera's frame.
struct Axes {
  explicit Axes(double heading_rad)
      : forward(std::cos(heading_rad), std::sin(heading_rad), 0.0),
        across(-std::sin(heading_rad), std::cos(heading_rad), 0.0) {}
  Vector3d forward;  ///< towards the fingertips
  Vector3d across;
  Vector3d up{0.0, 0.0, -1.0};  ///< towards the camera

  [[nodiscard]] Vector3d at(double forward_m, double across_m, double up_m) const {
    return forward_m * forward + across_m * across + up_m * up;
  }
};

/// The depth at which the ray along `ray` (z = 1) from the camera enters the sphere.
std::optional<double> enters_sphere(const Vector3d& ray, const Vector3d& centre, double radius_m) {
  const double a = ray.squaredNorm();
  const double b = ray.dot(centre);
  const double in = b * b - a * (centre.squaredNorm() - radius_m * radius_m);
  if (in < 0.0) return std::nullopt;
  return (b - std::sqrt(in)) / a;
}

/// The depth at which the ray enters the capsule: its cylinder, or the sphere at one of its ends.
std::optional<double> enters(const Vector3d& ray, const Capsule& capsule) {
  const Vector3d axis = capsule.to_m - capsule.from_m;
  const double length2 = axis.squaredNorm();
  const Vector3d across_ray = ray - ray.dot(axis) / length2 * axis;
  const Vector3d across_from = capsule.from_m - capsule.from_m.dot(axis) / length2 * axis;
  const double a = across_ray.squaredNorm();
  const double b = across_ray.dot(across_from);
  const double in = b * b - a * (across_from.squaredNorm() - capsule.radius_m * capsule.radius_m);
  if (in < 0.0) return std::nullopt;
  const double z = (b - std::sqrt(in)) / a;
  const double along = (z * ray - capsule.from_m).dot(axis) / length2;
  if (along < 0.0) return enters_sphere(ray, capsule.from_m, capsule.radius_m);
  if (along > 1.0) return enters_sphere(ray, capsule.to_m, capsule.radius_m);
  return z;
}

constexpr double kNearestHand_m = 0.1;  // what is nearer to the camera is not drawn

/// The first and the last pixel along one axis that the capsule may cover.
std::array<int, 2> covered(double from_m, double to_m, double radius_m, double nearest_m, double focal_px,
                           double centre_px, int size) {
  const auto pixel = [&](double at_m) { return std::clamp(focal_px * at_m / nearest_m + centre_px, -1.0, size + 0.0); };
  const double low_m = std::min(from_m, to_m) - radius_m;
  const double high_m = std::max(from_m, to_m) + radius_m;
  const double far_px =
      std::clamp(centre_px, 0.0, size - 1.0);  // a part that is farther away lies closer to the centre
  const double first = std::min(pixel(low_m), low_m < 0.0 ? pixel(low_m) : far_px);
  const double last = std::max(pixel(high_m), high_m > 0.0 ? pixel(high_m) : far_px);
  return {std::max(0, static_cast<int>(std::floor(first))), std::min(size - 1, static_cast<int>(std::ceil(last)))};
}

void draw(const Capsule& capsule, const Intrinsics& camera, std::vector<float>& depth_m) {
  const double nearest_m = std::max(kNearestHand_m, std::min(capsule.from_m.z(), capsule.to_m.z()) - capsule.radius_m);
  const auto columns =
      covered(capsule.from_m.x(), capsule.to_m.x(), capsule.radius_m, nearest_m, camera.fx, camera.cx, camera.width);
  const auto rows =
      covered(capsule.from_m.y(), capsule.to_m.y(), capsule.radius_m, nearest_m, camera.fy, camera.cy, camera.height);
  for (int v = rows[0]; v <= rows[1]; ++v)
    for (int u = columns[0]; u <= columns[1]; ++u) {
      const auto z = enters({(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0}, capsule);
      float& seen = depth_m[static_cast<std::size_t>(v * camera.width + u)];
      if (z && *z > kNearestHand_m && *z < static_cast<double>(seen)) seen = static_cast<float>(*z);
    }
}

}  // namespace

std::vector<Capsule> capsules_of(const ColleagueHand& hand) {
  const Axes axes(hand.heading_rad);
  const auto at = [&](double forward_m, double across_m, double up_m) -> Vector3d {
    return hand.under_palm_m + axes.at(forward_m, across_m, up_m);
  };
  std::vector<Capsule> all;
  for (std::size_t i = 0; i < kFingers_m.size(); ++i) {
    const double lift = hand.lifts[i + 1];
    const Vector3d knuckle = at(kKnuckles_m, kAcross_m[i], kPalm_m);
    all.push_back({at(kHeel_m, 0.8 * kAcross_m[i], kPalm_m), knuckle, kPalm_m});
    all.push_back({at(kKnuckles_m, kAcross_m[i], kFinger_m),
                   at(kKnuckles_m + kFingers_m[i] * std::cos(lift), 1.15 * kAcross_m[i],
                      kFinger_m + kFingers_m[i] * std::sin(lift)),
                   kFinger_m});
  }
  all.push_back({at(-0.025, 0.030, kThumb_m), at(0.015, 0.070, kThumb_m + 0.05 * std::sin(hand.lifts[0])), kThumb_m});
  const Vector3d wrist = at(kHeel_m - 0.02, 0.0, kWrist_m);
  const Vector3d along = axes.at(-std::cos(hand.arm_rise_rad), 0.0, std::sin(hand.arm_rise_rad));
  constexpr int kParts = 5;
  for (int part = 0; part < kParts; ++part) {
    const double from = static_cast<double>(part) / kParts;
    const double to = static_cast<double>(part + 1) / kParts;
    all.push_back(
        {wrist + kArm_m * from * along, wrist + kArm_m * to * along, kWrist_m + from * (kElbow_m - kWrist_m)});
  }
  return all;
}

void draw_over(const std::vector<Capsule>& capsules, const Intrinsics& camera, std::vector<float>& depth_m) {
  for (const Capsule& capsule : capsules) draw(capsule, camera, depth_m);
}

}  // namespace telepalp::capture
