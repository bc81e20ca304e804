#include "server/capture/pcd/pinhole_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace telepalp::capture {
namespace {

constexpr std::size_t kFewestPoints = 100;
constexpr double kMostResidual_px = 0.7;

/// Least squares for pixel = focal * ratio + centre; points are added one at a time.
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

bool measured(const Eigen::Vector3f& point) { return point.allFinite() && point.z() > 0.0F; }

std::optional<Error> refuse_shape(const models::PointModel& cloud, const std::string& name) {
  const std::string fix = "give an organised PCD (one point a pixel), as PCL saves a camera's cloud";
  if (cloud.width <= 1 || cloud.points.empty())
    return Error{
        .what = "is not organised: its points are not arranged in rows and columns", .where = name, .fix = fix};
  const std::size_t height = cloud.points.size() / static_cast<std::size_t>(cloud.width);
  if (cloud.width > kMaxImageSide || height > static_cast<std::size_t>(kMaxImageSide))
    return Error{.what = "is " + std::to_string(cloud.width) + " x " + std::to_string(height) + " points, more than " +
                         std::to_string(kMaxImageSide) + " a side",
                 .where = name,
                 .fix = "give a cloud of at most " + std::to_string(kMaxImageSide) + " points a side"};
  return std::nullopt;
}

ColorImage color_of(const models::PointModel& cloud, int height) {
  ColorImage color;
  if (cloud.colors.empty()) return color;
  color.width = cloud.width;
  color.height = height;
  color.rgb.reserve(3 * cloud.colors.size());
  for (const auto& rgb : cloud.colors) color.rgb.insert(color.rgb.end(), rgb.begin(), rgb.end());
  return color;
}

}  // namespace

Result<RgbdFrame> frame_of(const models::PointModel& cloud, const std::string& name) {
  if (const auto error = refuse_shape(cloud, name)) return *error;
  Line across;
  Line down;
  double furthest_m = 0.0;
  const auto width = static_cast<std::size_t>(cloud.width);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!measured(cloud.points[i])) continue;
    const Eigen::Vector3d point = cloud.points[i].cast<double>();
    across.add(point.x() / point.z(), static_cast<double>(i % width));
    down.add(point.y() / point.z(), static_cast<double>(i / width));
    furthest_m = std::max(furthest_m, point.z());
  }
  const std::string fix =
      "give the cloud of one camera in its own frame (x right, y down, z into the scene), one point a pixel";
  if (across.count() < kFewestPoints)
    return Error{.what = "has too few points in front of the camera: " + std::to_string(across.count()) +
                         " instead of at least " + std::to_string(kFewestPoints),
                 .where = name,
                 .fix = fix};
  if (!(across.focal() > 0.0 && down.focal() > 0.0))
    return Error{.what =
                     "is not in its camera's frame: x does not grow from the left to the right column of the "
                     "cloud, or y does not grow from the upper to the lower row",
                 .where = name,
                 .fix = fix};
  if (!(across.rms() <= kMostResidual_px && down.rms() <= kMostResidual_px))
    return Error{.what = "was not seen by a pinhole camera: points lie " +
                         std::to_string(std::max(across.rms(), down.rms())) +
                         " pixels (root mean square) from where a pinhole camera sees them",
                 .where = name,
                 .fix = fix};

  const int height = static_cast<int>(cloud.points.size() / width);
  RgbdFrame frame;
  frame.camera.depth = {cloud.width, height, across.focal(), down.focal(), across.centre(), down.centre()};
  frame.camera.color = frame.camera.depth;
  frame.depth = {cloud.width, height, furthest_m < 6.5 ? 0.0001 : 0.001,
                 std::vector<std::uint16_t>(cloud.points.size(), 0)};
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double steps = static_cast<double>(cloud.points[i].z()) / frame.depth.unit_m;
    if (measured(cloud.points[i]) && steps < 65535.0)
      frame.depth.samples[i] = static_cast<std::uint16_t>(std::lround(steps));
  }
  frame.color = color_of(cloud, height);
  return frame;
}

}  // namespace telepalp::capture
