#include "tools/export_tool/cloud_file.h"

#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace telepalp::export_tool {
namespace {

static_assert(std::endian::native == std::endian::little, "both formats are written in the byte order of this machine");

struct Point {
  std::array<float, 3> m;
  std::array<std::uint8_t, 3> rgb;
  bool measured;
};

bool has_color(const RgbdFrame& frame) {
  return frame.camera.color_registered && frame.color.width == frame.depth.width &&
         frame.color.height == frame.depth.height;
}

Point point_at(const RgbdFrame& frame, int column, int row) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const Intrinsics& camera = frame.camera.depth;
  const double z_m = frame.depth.at(column, row) * frame.depth.unit_m;
  Point point{.m = {kNone, kNone, kNone}, .rgb = {}, .measured = z_m > 0.0};
  if (point.measured)
    point.m = {static_cast<float>((column - camera.cx) / camera.fx * z_m),
               static_cast<float>((row - camera.cy) / camera.fy * z_m), static_cast<float>(z_m)};
  if (!has_color(frame)) return point;
  const auto* const pixel =
      frame.color.rgb.data() + 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.color.width) +
                                    static_cast<std::size_t>(column));
  point.rgb = {pixel[0], pixel[1], pixel[2]};
  return point;
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Take>
void for_each_point(const RgbdFrame& frame, Take take) {
  for (int row = 0; row < frame.depth.height; ++row)
    for (int column = 0; column < frame.depth.width; ++column) take(point_at(frame, column, row));
}

}  // namespace

std::string ply_of(const RgbdFrame& frame) {
  std::string body;
  std::size_t count = 0;
  for_each_point(frame, [&](const Point& point) {
    if (!point.measured) return;
    append(body, point.m);
    if (has_color(frame)) append(body, point.rgb);
    ++count;
  });
  std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment telepalp-export: metres, depth camera's frame\nelement vertex " +
      std::to_string(count) + "\nproperty float x\nproperty float y\nproperty float z\n";
  if (has_color(frame)) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  return header + "end_header\n" + body;
}

std::string pcd_of(const RgbdFrame& frame) {
  const bool colored = has_color(frame);
  const std::string width = std::to_string(frame.depth.width);
  const std::string height = std::to_string(frame.depth.height);
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z";
  bytes += colored ? " rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n" : "\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  bytes += "WIDTH " + width + "\nHEIGHT " + height + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
           std::to_string(frame.depth.samples.size()) + "\nDATA binary\n";
  for_each_point(frame, [&](const Point& point) {
    append(bytes, point.m);
    // PCD packs a colour into the bits of a float: 0x00RRGGBB.
    const std::uint32_t packed =
        (std::uint32_t{point.rgb[0]} << 16) | (std::uint32_t{point.rgb[1]} << 8) | point.rgb[2];
    if (colored) append(bytes, packed);
  });
  return bytes;
}

}  // namespace telepalp::export_tool
