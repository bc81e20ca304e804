#include "proto/wire/inside/inside_message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace telepalp::wire {
namespace {

constexpr double kFurthest_m = 10.0;
constexpr std::size_t kPointBytes = 6;
constexpr std::size_t kTriangleBytes = 6;

/// False for NaN, too.
bool is_within(double value, double least, double most) noexcept { return value >= least && value <= most; }

bool is_near(const msg::Vec3& at) noexcept {
  return is_within(at.x(), -kFurthest_m, kFurthest_m) && is_within(at.y(), -kFurthest_m, kFurthest_m) &&
         is_within(at.z(), -kFurthest_m, kFurthest_m);
}

bool is_direction(const msg::Vec3& unit) noexcept {
  return is_within(std::hypot(unit.x(), unit.y(), unit.z()), 0.99, 1.01);
}

bool is_turn(const msg::Rotation& q) noexcept {
  return is_within(std::hypot(std::hypot(q.x(), q.y()), std::hypot(q.z(), q.w())), 0.99, 1.01);
}

bool names_points(const std::string& triangles, std::size_t points) noexcept {
  for (std::size_t i = 0; i + 1 < triangles.size(); i += 2) {
    const auto low = static_cast<std::uint8_t>(triangles[i]);
    const auto high = static_cast<std::uint8_t>(triangles[i + 1]);
    if (low + 256U * high >= points) return false;
  }
  return true;
}

bool is_valid_structure(const msg::InnerStructure& structure) noexcept {
  const std::size_t points = structure.points().size() / kPointBytes;
  return structure.points().size() % kPointBytes == 0 && points <= kMostStructurePoints &&
         structure.triangles().size() % kTriangleBytes == 0 && names_points(structure.triangles(), points) &&
         is_near(structure.least()) && is_within(structure.step_m(), 0.0, kFurthest_m / 65535.0);
}

}  // namespace

bool is_valid(const msg::UltrasoundImage& image) noexcept {
  constexpr std::string_view kJpegBegins("\xff\xd8\xff", 3);
  const bool pictured = !image.jpeg().empty();
  if (pictured && (image.jpeg().size() > kMaxUltrasoundBytes || !image.jpeg().starts_with(kJpegBegins))) return false;
  if (pictured != image.on_skin()) return false;
  const bool posed =
      is_near(image.face_camera()) && is_direction(image.into_body_camera()) && is_direction(image.across_camera());
  return (posed || !pictured) && is_within(image.width_m(), 0.001, 1.0) && is_within(image.depth_m(), 0.001, 1.0) &&
         is_within(image.compute_ms(), 0.0, 1e6);
}

bool is_valid(const msg::InnerStructures& inside) noexcept {
  if (inside.structures_size() > kMostStructures) return false;
  if (inside.structures_size() > 0 &&
      (!is_near(inside.haptic_origin_camera()) || !is_turn(inside.camera_from_haptic())))
    return false;
  return std::ranges::all_of(inside.structures(), is_valid_structure);
}

}  // namespace telepalp::wire
