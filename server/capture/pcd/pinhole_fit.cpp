#include <cmath>

#include "server/capture/pcd/pcd.h"

namespace telepalp::server {
namespace {

constexpr std::size_t kFewestPoints = 100;
constexpr double kMostResidual_px = 0.7;

/// Least squares of pixel = focal * ratio + centre, gathered point by point.
class Line {
 public:
  void add(double ratio, double pixel) {
    ++count_;
    const double n = static_cast<double>(count_);
    const double ratio_off = ratio - mean_ratio_;
    const double pixel_off = pixel - mean_pixel_;
    mean_ratio_ += ratio_off / n;
    mean_pixel_ += pixel_off / n;
    ratio_ratio_ += ratio_off * (ratio - mean_ratio_);
    ratio_pixel_ += ratio_off * (pixel - mean_pixel_);
    pixel_pixel_ += pixel_off * (pixel - mean_pixel_);
  }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] double focal() const noexcept { return ratio_pixel_ / ratio_ratio_; }
  [[nodiscard]] double centre() const noexcept { return mean_pixel_ - focal() * mean_ratio_; }
  [[nodiscard]] double rms() const noexcept {
    return std::sqrt(std::max(pixel_pixel_ - focal() * ratio_pixel_, 0.0) / static_cast<double>(count_));
  }

 private:
  std::size_t count_ = 0;
  double mean_ratio_ = 0.0;
  double mean_pixel_ = 0.0;
  double ratio_ratio_ = 0.0;
  double ratio_pixel_ = 0.0;
  double pixel_pixel_ = 0.0;
};

bool measured(const OrganisedCloud& cloud, std::size_t i) {
  return std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i]) && cloud.z[i] > 0.0F;
}

}  // namespace

Result<RgbdFrame> frame_of(const OrganisedCloud& cloud, const std::string& name) {
  Line across;
  Line down;
  double furthest_m = 0.0;
  const auto width = static_cast<std::size_t>(cloud.width);
  for (std::size_t i = 0; i < cloud.z.size(); ++i) {
    if (!measured(cloud, i)) continue;
    const double z = static_cast<double>(cloud.z[i]);
    across.add(static_cast<double>(cloud.x[i]) / z, static_cast<double>(i % width));
    down.add(static_cast<double>(cloud.y[i]) / z, static_cast<double>(i / width));
    furthest_m = std::max(furthest_m, z);
  }
  const std::string fix =
      "give a cloud in its camera's own frame (x right, y down, z into the scene), not moved, "
      "filtered into another order or merged";
  if (across.count() < kFewestPoints)
    return Error{
        .what = "has only " + std::to_string(across.count()) + " points before the camera", .where = name, .fix = fix};
  if (!(across.rms() <= kMostResidual_px && down.rms() <= kMostResidual_px && across.focal() > 0.0 &&
        down.focal() > 0.0))
    return Error{.what = "was not seen by a pinhole camera: points lie " +
                         std::to_string(std::max(across.rms(), down.rms())) + " pixels from where they should",
                 .where = name,
                 .fix = fix};

  RgbdFrame frame;
  frame.camera.depth = {cloud.width, cloud.height, across.focal(), down.focal(), across.centre(), down.centre()};
  frame.camera.color = frame.camera.depth;
  frame.depth = {cloud.width, cloud.height, furthest_m < 6.5 ? 0.0001 : 0.001,
                 std::vector<std::uint16_t>(cloud.z.size(), 0)};
  for (std::size_t i = 0; i < cloud.z.size(); ++i) {
    const double steps = static_cast<double>(cloud.z[i]) / frame.depth.unit_m;
    if (measured(cloud, i) && steps < 65535.0) frame.depth.samples[i] = static_cast<std::uint16_t>(std::lround(steps));
  }
  if (!cloud.rgb.empty()) frame.color = {cloud.width, cloud.height, cloud.rgb};
  return frame;
}

}  // namespace telepalp::server
