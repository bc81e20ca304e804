#include "server/views/depth_views.h"

#include <array>
#include <cmath>
#include <initializer_list>

#include "proto/wire/camera/camera_stamp.h"
#include "proto/words/color_at.h"
#include "proto/words/little_endian.h"

namespace telepalp::views {
namespace {

constexpr double kMillimetresPerMetre = 1000.0;
constexpr std::size_t kPlaceBytes = 3 * sizeof(float);
constexpr std::size_t kColorBytes = 4;

/// Adds fields that lie one behind the other from `offset` on.
void add_fields(foxglove::PointCloud& cloud, std::initializer_list<const char*> names, std::size_t offset,
                foxglove::PackedElementField::NumericType type, std::size_t bytes) {
  for (const char* name : names) {
    foxglove::PackedElementField& field = *cloud.add_fields();
    field.set_name(name);
    field.set_offset(static_cast<std::uint32_t>(offset));
    field.set_type(type);
    offset += bytes;
  }
}

/// The step in rows and columns between the points that are kept.
int thinning(const DepthImage& depth) noexcept {
  constexpr int kMostPoints = 500'000;
  int step = 1;
  while ((depth.width / step) * (depth.height / step) > kMostPoints) ++step;
  return step;
}

void append_point(std::string& bytes, const Intrinsics& camera, int column, int row, double z_m) {
  const float point[3] = {static_cast<float>((column - camera.cx) / camera.fx * z_m),
                          static_cast<float>((row - camera.cy) / camera.fy * z_m), static_cast<float>(z_m)};
  bytes.append(reinterpret_cast<const char*>(point), sizeof point);
}

/// Opaque, in the order of the fields red, green, blue, alpha.
void append_color(std::string& bytes, const std::array<std::uint8_t, 3>& rgb) {
  for (const std::uint8_t value : rgb) bytes.push_back(static_cast<char>(value));
  bytes.push_back('\xff');
}

std::uint16_t millimetres(std::uint16_t sample, double unit_m) noexcept {
  constexpr double kMost = 65535.0;
  const double depth_mm = std::round(sample * unit_m * kMillimetresPerMetre);
  return depth_mm > kMost ? std::uint16_t{0} : static_cast<std::uint16_t>(depth_mm);
}

}  // namespace

foxglove::RawImage depth_view(const DepthImage& depth, SessionTime captured) {
  foxglove::RawImage image;
  wire::set_stamp(*image.mutable_timestamp(), captured);
  image.set_frame_id(wire::kDepthFrameId);
  image.set_width(static_cast<std::uint32_t>(depth.width));
  image.set_height(static_cast<std::uint32_t>(depth.height));
  image.set_encoding("16UC1");
  image.set_step(static_cast<std::uint32_t>(depth.width) * 2u);
  std::string& bytes = *image.mutable_data();
  bytes.resize(depth.samples.size() * 2);
  for (std::size_t pixel = 0; pixel < depth.samples.size(); ++pixel) {
    put_little_endian<std::uint16_t>(bytes.data() + 2 * pixel, millimetres(depth.samples[pixel], depth.unit_m));
  }
  return image;
}

foxglove::PointCloud cloud_view(const RgbdFrame& frame) {
  const bool colored = !frame.color.rgb.empty();
  const std::size_t stride = kPlaceBytes + (colored ? kColorBytes : 0);
  foxglove::PointCloud cloud;
  wire::set_stamp(*cloud.mutable_timestamp(), frame.captured);
  cloud.set_frame_id(wire::kDepthFrameId);
  cloud.mutable_pose()->mutable_position();
  cloud.mutable_pose()->mutable_orientation()->set_w(1.0);
  cloud.set_point_stride(static_cast<std::uint32_t>(stride));
  add_fields(cloud, {"x", "y", "z"}, 0, foxglove::PackedElementField::FLOAT32, sizeof(float));
  if (colored)
    add_fields(cloud, {"red", "green", "blue", "alpha"}, kPlaceBytes, foxglove::PackedElementField::UINT8, 1);
  const DepthImage& depth = frame.depth;
  std::string& bytes = *cloud.mutable_data();
  const int step = thinning(depth);
  bytes.reserve(depth.samples.size() / static_cast<std::size_t>(step * step) * stride);
  for (int row = 0; row < depth.height; row += step)
    for (int column = 0; column < depth.width; column += step)
      if (const std::uint16_t sample = depth.at(column, row); sample != 0) {
        append_point(bytes, frame.camera.depth, column, row, sample * depth.unit_m);
        if (colored) append_color(bytes, color_at(frame, column, row));
      }
  return cloud;
}

}  // namespace telepalp::views
