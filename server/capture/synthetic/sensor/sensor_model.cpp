#include "server/capture/synthetic/sensor/sensor_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/capture/synthetic/sensor/holes.h"
#include "server/capture/synthetic/shape/colleague_hand.h"
#include "support/sensor/pixel_noise.h"

namespace telepalp::capture {
namespace {

sensor::DepthSensorSettings sensor_of(const SyntheticSettings& settings) {
  return {.noise = settings.noise,
          .gaussian_sigma_m = settings.gaussian_sigma_m,
          .disparity_steps = settings.disparity_steps,
          .unit_m = settings.depth_unit_m,
          .seed = settings.seed};
}

}  // namespace

SensorModel::SensorModel(std::shared_ptr<const RestShape> rest_shape, const SyntheticSettings& settings)
    : rest_(std::move(rest_shape)), holes_(settings.holes), sensor_(sensor_of(settings)) {
  const RestShape& rest = *rest_;
  const Intrinsics& camera = rest.camera;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const bool body = rest.meets_body(u, v);
      rest_depth_m_.push_back(static_cast<float>(body ? rest.body_depth_m.at(u, v).value : rest.table_depth_m));
      lift_share_.push_back(body ? static_cast<float>(rest.lift_share(u, v).value) : 0.0F);
    }
  hole_of_256_ = settings.holes ? hole_map(rest_depth_m_, camera) : std::vector<std::uint8_t>(rest_depth_m_.size(), 0);
}

SensorModel::Moved SensorModel::moved_to(const PatientPose& pose) const {
  const RestShape& rest = *rest_;
  const int width = rest.camera.width;
  Moved moved{rest_depth_m_, lift_share_, hole_of_256_};
  for (std::size_t i = 0; i < rest_depth_m_.size(); ++i) {
    const auto u = static_cast<double>(i % static_cast<std::size_t>(width));
    const auto v = static_cast<double>(i / static_cast<std::size_t>(width));
    bool body = lift_share_[i] != 0.0F || rest.meets_body(u, v);
    if (pose.slides()) {
      const Eigen::Vector2d still = rest.at_rest(u, v, pose.slide_m);
      body = rest.meets_body(still.x(), still.y());
      moved.depth_m[i] =
          static_cast<float>(body ? rest.body_depth_m.at(still.x(), still.y()).value : rest.table_depth_m);
      moved.lift_share[i] = body ? static_cast<float>(rest.lift_share(still.x(), still.y()).value) : 0.0F;
      const auto from_u = static_cast<std::size_t>(std::clamp(still.x() + 0.5, 0.0, width - 1.0));
      const auto from_v = static_cast<std::size_t>(std::clamp(still.y() + 0.5, 0.0, rest.camera.height - 1.0));
      moved.hole_of_256[i] = hole_of_256_[from_v * static_cast<std::size_t>(width) + from_u];
    }
    if (body) moved.depth_m[i] -= static_cast<float>(body_rise(pose, rest.body_coordinates_m(u, v).x()).m);
  }
  return moved;
}

/// The picture of a pose with a colleague's hand, breath included, with the hand's own shadow and ragged silhouette.
SensorModel::Moved SensorModel::with_hand(const PatientPose& pose) const {
  Moved seen = moved_to(pose);
  const auto lift_m = static_cast<float>(pose.breath.lift_m);
  for (std::size_t i = 0; i < seen.depth_m.size(); ++i) seen.depth_m[i] -= lift_m * seen.lift_share[i];
  std::fill(seen.lift_share.begin(), seen.lift_share.end(), 0.0F);
  draw_over(capsules_of(*pose.colleague), rest_->camera, seen.depth_m);
  if (holes_) seen.hole_of_256 = hole_map(seen.depth_m, rest_->camera);
  return seen;
}

void SensorModel::measure(const PatientPose& pose, std::int64_t instant, std::vector<std::uint16_t>& out) const {
  out.resize(rest_depth_m_.size());
  const bool lies_at_rest = !pose.slides() && !pose.rises() && !pose.colleague;
  Moved moved;
  if (pose.colleague)
    moved = with_hand(pose);
  else if (!lies_at_rest)
    moved = moved_to(pose);
  const std::vector<std::uint8_t>& hole_of_256 = lies_at_rest ? hole_of_256_ : moved.hole_of_256;
  const float* const depth_m = (lies_at_rest ? rest_depth_m_ : moved.depth_m).data();
  const float* const lift_share = (lies_at_rest ? lift_share_ : moved.lift_share).data();
  const auto lift_m = static_cast<float>(pose.breath.lift_m);
  const sensor::Exposure exposure = sensor_.expose(instant);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint32_t bits = exposure.bits(static_cast<std::uint32_t>(i));
    const std::uint16_t sample = exposure.sample_of(depth_m[i] - lift_m * lift_share[i], bits);
    out[i] = (bits >> 24U) < hole_of_256[i] || hole_of_256[i] == 255 ? std::uint16_t{0} : sample;
  }
}

void add_color_noise(std::vector<std::uint8_t>& rgb, std::int64_t instant, std::uint64_t seed) {
  const sensor::PixelNoise noise{seed ^ 0xC01055ULL, instant};
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const std::uint32_t bits = noise.bits(static_cast<std::uint32_t>(i));
    // The sum of two uniform two-bit numbers minus 3: -3 to 3, most often 0.
    const int by = static_cast<int>((bits >> 8U) & 3U) + static_cast<int>((bits >> 16U) & 3U) - 3;
    for (std::size_t channel = i; channel < i + 3; ++channel)
      rgb[channel] = static_cast<std::uint8_t>(std::clamp(rgb[channel] + by, 0, 255));
  }
}

}  // namespace telepalp::capture
