#include "server/capture/synthetic/appearance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "proto/words/smooth_step.h"
#include "server/capture/synthetic/shape/smooth.h"
#include "server/capture/synthetic/true_surface.h"
#include "support/sensor/pixel_noise.h"

namespace telepalp::capture {
namespace {

// Linear light, 0 to 1.
const Eigen::Vector3d kSkin{0.62, 0.38, 0.28};
const Eigen::Vector3d kFlush{0.60, 0.28, 0.22};  // skin colour where blood is visible
const Eigen::Vector3d kAreola{0.36, 0.17, 0.13};
const Eigen::Vector3d kCloth{0.10, 0.22, 0.36};
const Eigen::Vector3d kSheet{0.62, 0.68, 0.66};

constexpr double kAreolaAlong_m = 0.155;
constexpr double kAreolaAcross_m = 0.108;
constexpr double kAreolaRadius_m = 0.013;

/// Value noise: random numbers on a lattice of unit cells, smoothly interpolated; -1 to 1.
double value_noise(const sensor::PixelNoise& noise, const Eigen::Vector2d& at) {
  const Eigen::Vector2d cell{std::floor(at.x()), std::floor(at.y())};
  const Eigen::Vector2d t = at - cell;
  const Eigen::Vector2d s = t.cwiseProduct(t).cwiseProduct(Eigen::Vector2d{3.0, 3.0} - 2.0 * t);
  const auto corner = [&](int dx, int dy) {
    const auto x = static_cast<std::uint32_t>(static_cast<int>(cell.x()) + dx + (1 << 14));
    const auto y = static_cast<std::uint32_t>(static_cast<int>(cell.y()) + dy + (1 << 14));
    return static_cast<double>(noise.bits((x << 16U) ^ y)) / 2147483648.0 - 1.0;
  };
  const double top = corner(0, 0) + s.x() * (corner(1, 0) - corner(0, 0));
  const double bottom = corner(0, 1) + s.x() * (corner(1, 1) - corner(0, 1));
  return top + s.y() * (bottom - top);
}

/// `at`: along the body and across it [m]; `cloth` 0 to 1.
Eigen::Vector3d body_albedo(const Eigen::Vector2d& at, double cloth, const sensor::PixelNoise& noise) {
  const double mottling = 0.6 * value_noise(noise, at / 0.05) + 0.4 * value_noise(noise, at / 0.017);
  const double pores = 0.6 * value_noise(noise, at / 0.0045) + 0.4 * value_noise(noise, at / 0.0022);
  Eigen::Vector3d albedo = kSkin + (0.25 + 0.25 * mottling) * (kFlush - kSkin);
  const Eigen::Vector2d nipple{kAreolaAlong_m, std::copysign(kAreolaAcross_m, at.y())};
  const double ragged = kAreolaRadius_m * (1.0 + 0.15 * value_noise(noise, at / 0.006));
  albedo += 0.7 * (1.0 - smooth_step(0.75 * ragged, 1.15 * ragged, (at - nipple).norm())) * (kAreola - albedo);
  albedo *= 1.0 + 0.07 * pores;
  const double weave = 1.0 + 0.06 * value_noise(noise, at / 0.003) + 0.08 * value_noise(noise, at / 0.04);
  return albedo + cloth * (kCloth * weave - albedo);
}

Eigen::Vector3d sheet_albedo(const Eigen::Vector2d& at, const sensor::PixelNoise& noise) {
  const double folds = value_noise(noise, {at.x() / 0.25, at.y() / 0.06});
  return kSheet * (1.0 + 0.06 * folds + 0.03 * value_noise(noise, at / 0.004));
}

std::uint8_t display(double linear) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::pow(std::clamp(linear, 0.0, 1.0), 1.0 / 2.2)));
}

/// How much of the sky each pixel sees, 0 to 1: a pixel deeper than its surroundings sees less.
std::vector<float> openness(const RestShape& rest) {
  const ImageSize size{rest.camera.width, rest.camera.height};
  std::vector<float> depth;
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u)
      depth.push_back(
          static_cast<float>(rest.meets_body(u, v) ? rest.body_depth_m.at(u, v).value : rest.table_depth_m));
  const std::vector<float> wide = blur(depth, size, 24.0);
  const std::vector<float> near = blur(depth, size, 6.0);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const bool table = depth[i] >= static_cast<float>(rest.table_depth_m);
    const float hollow_m = std::max(depth[i] - wide[i], 0.0F);
    const float crease_m = std::max(depth[i] - near[i], 0.0F);
    depth[i] =
        table ? std::max(1.0F - 4.0F * hollow_m, 0.5F) : std::max(1.0F - 9.0F * hollow_m - 14.0F * crease_m, 0.35F);
  }
  return depth;
}

}  // namespace

ColorImage paint(const RestShape& rest, std::uint64_t seed) {
  const TrueSurface surface{std::make_shared<const RestShape>(rest), PatientPose{}};
  const sensor::PixelNoise noise{seed, 0};
  const Eigen::Vector3d to_light = Eigen::Vector3d{-0.7, -0.75, -1.0}.normalized();
  const std::vector<float> open = openness(rest);
  ColorImage picture{rest.camera.width, rest.camera.height, {}};
  picture.rgb.reserve(3 * open.size());
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u) {
      const TrueSurfacePoint point = surface.at_pixel(u, v);
      const Eigen::Vector2d at = rest.body_coordinates_m(u, v);
      const Eigen::Vector3d albedo =
          point.on_body ? body_albedo(at, rest.cloth_share(u, v), noise) : sheet_albedo(at, noise);
      // Wrapped Lambert shading: skin scatters light into the edge of the shadow.
      const double lambert = std::max(0.0, (point.normal.v.dot(to_light) + 0.25) / 1.25);
      const double light = static_cast<double>(open[picture.rgb.size() / 3]) * (0.16 + 0.95 * lambert);
      for (int channel = 0; channel < 3; ++channel) picture.rgb.push_back(display(light * albedo[channel]));
    }
  return picture;
}

void paint_glove(const ColleagueHand& hand, const Intrinsics& camera, ColorImage& picture) {
  constexpr float kFar_m = 100.0F;
  constexpr double kSleeve_m = 0.12;  // from the palm's middle; what is farther away is sleeve
  std::vector<float> depth_m(picture.rgb.size() / 3, kFar_m);
  draw_over(capsules_of(hand), camera, depth_m);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (depth_m[i] >= kFar_m) continue;
    const auto z_m = static_cast<double>(depth_m[i]);
    const auto u = static_cast<double>(i % static_cast<std::size_t>(picture.width));
    const auto v = static_cast<double>(i / static_cast<std::size_t>(picture.width));
    const Eigen::Vector2d from_palm_m{(u - camera.cx) / camera.fx * z_m - hand.under_palm_m.x(),
                                      (v - camera.cy) / camera.fy * z_m - hand.under_palm_m.y()};
    const double ahead_m = from_palm_m.x() * std::cos(hand.heading_rad) + from_palm_m.y() * std::sin(hand.heading_rad);
    const bool sleeve = ahead_m < -kSleeve_m;
    // Brighter towards the camera, so that fingers can be told apart.
    const double light = std::clamp(0.5 + 12.0 * (hand.under_palm_m.z() - z_m), 0.45, 1.0);
    const Eigen::Vector3d albedo = sleeve ? Eigen::Vector3d{0.75, 0.78, 0.8} : Eigen::Vector3d{0.12, 0.3, 0.62};
    for (int channel = 0; channel < 3; ++channel)
      picture.rgb[3 * i + static_cast<std::size_t>(channel)] = display(light * albedo[channel]);
  }
}

}  // namespace telepalp::capture
