#include "clients/mixed/background/background.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/images/triangle_scan.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;

constexpr int kShrink = 4;                // a source's depth map has a quarter of its image's width and height
constexpr double kDepthTolerance = 0.02;  // a vertex this share of its depth behind the map is still seen
constexpr double kEdge_px = 2.0;          // a vertex nearer to the image's edge is not seen

Error background_refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "background", .fix = std::move(fix)};
}

Intrinsics shrunk(const Intrinsics& lens) {
  return {lens.width / kShrink, lens.height / kShrink, lens.fx / kShrink,
          lens.fy / kShrink,    lens.cx / kShrink,     lens.cy / kShrink};
}

/// 1 / depth of the nearest triangle at each pixel; 0 where no triangle is.
std::vector<float> inverse_depths(const Proxy& proxy, const std::vector<Vector3d>& eye_m, const Intrinsics& lens) {
  std::vector<float> nearest(static_cast<std::size_t>(lens.width) * static_cast<std::size_t>(lens.height), 0.0F);
  for (const auto& triangle : proxy.triangles) {
    std::array<Vector2f, 3> at;
    std::array<float, 3> inverse{};
    bool before = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto image = image_of(lens, Point<Eye>{eye_m[triangle[i]]});
      before = before && image.has_value();
      if (!image) break;
      at[i] = image->cast<float>();
      inverse[i] = static_cast<float>(1.0 / eye_m[triangle[i]].z());
    }
    if (!before) continue;
    images::scan_triangle(at[0], at[1], at[2], lens.width, lens.height, [&](int x, int y, float a, float b, float c) {
      float& here =
          nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(lens.width) + static_cast<std::size_t>(x)];
      here = std::max(here, a * inverse[0] + b * inverse[1] + c * inverse[2]);
    });
  }
  return nearest;
}

/// True if the depth map shows nothing in front of a point. The farthest of the nine pixels around it decides: a vertex
/// at the outline of a nearer object can share its pixel with that object and is visible nevertheless.
bool is_unobstructed(const std::vector<float>& inverse, const Intrinsics& lens, const Eigen::Vector2d& at, double z_m) {
  const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y()));
  float farthest = 1e9F;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, lens.height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, lens.width - 1); ++column)
      farthest = std::min(farthest, inverse[static_cast<std::size_t>(row) * static_cast<std::size_t>(lens.width) +
                                            static_cast<std::size_t>(column)]);
  return farthest * z_m <= 1.0 + kDepthTolerance;
}

Result<void> check(const std::vector<SourceImage>& sources, const Proxy& proxy) {
  if (sources.empty())
    return background_refusal("it has no image", "take images of the desk without the device from several places");
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const SourceImage& source = sources[i];
    if (!is_well_formed(source.color) || source.color.rgb.empty() || !is_well_formed(source.view.intrinsics) ||
        source.color.width != source.view.intrinsics.width || source.color.height != source.view.intrinsics.height)
      return background_refusal("image " + std::to_string(i + 1) + " does not have the size of its camera's intrinsics",
                                "calibrate the camera at the size of its images");
    if (!source.view.world_from_eye.iso.matrix().allFinite())
      return background_refusal("the pose of image " + std::to_string(i + 1) + " is not finite",
                                "leave this image out");
  }
  if (proxy.triangles.empty())
    return background_refusal("its proxy has no triangle",
                              "give the planes of desk and walls, or a depth camera's mesh");
  for (const auto& triangle : proxy.triangles)
    for (const std::uint32_t vertex : triangle)
      if (vertex >= proxy.vertices.size() || !proxy.vertices[vertex].allFinite())
        return background_refusal("its proxy has a triangle with a vertex that does not exist or is not finite",
                                  "export the mesh again");
  return {};
}

}  // namespace

Proxy plane_proxy(const Vector3d& corner, const Vector3d& along, const Vector3d& across, int columns, int rows) {
  Proxy proxy;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      proxy.vertices.emplace_back(corner + along * column / columns + across * row / rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto first = static_cast<std::uint32_t>(row * (columns + 1) + column);
      const auto below = first + static_cast<std::uint32_t>(columns) + 1;
      proxy.triangles.push_back({first, first + 1, below});
      proxy.triangles.push_back({first + 1, below + 1, below});
    }
  return proxy;
}

Proxy depth_proxy(const DepthImage& depth, const View& view, int step_px, double jump_m) {
  const Intrinsics& lens = view.intrinsics;
  const int columns = (depth.width - 1) / step_px + 1, rows = (depth.height - 1) / step_px + 1;
  Proxy proxy;
  std::vector<double> z_m;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x = column * step_px, y = row * step_px;
      const double z = depth.at(x, y) * depth.unit_m;
      z_m.push_back(z);
      const Point<Eye> at{{(x - lens.cx) / lens.fx * z, (y - lens.cy) / lens.fy * z, z}};
      proxy.vertices.push_back((view.world_from_eye * at).m);
    }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto [least, most] = std::minmax({z_m[a], z_m[b], z_m[c]});
    if (least > 0.0 && most - least <= jump_m)
      proxy.triangles.push_back(
          {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  };
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const auto first = static_cast<std::size_t>(row * columns + column);
      const std::size_t below = first + static_cast<std::size_t>(columns);
      add(first, first + 1, below);
      add(first + 1, below + 1, below);
    }
  return proxy;
}

void append(Proxy& proxy, const Proxy& more) {
  const auto first = static_cast<std::uint32_t>(proxy.vertices.size());
  proxy.vertices.insert(proxy.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& [a, b, c] : more.triangles) proxy.triangles.push_back({a + first, b + first, c + first});
}

Result<Background> Background::prepare(std::vector<SourceImage> sources, Proxy proxy) {
  if (const Result<void> usable = check(sources, proxy); !usable) return usable.error();
  Background background;
  background.sources_ = std::move(sources);
  background.proxy_ = std::move(proxy);
  background.directions_.assign(background.proxy_.vertices.size() * background.sources_.size(),
                                Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < background.sources_.size(); ++i) background.look_from(i);
  return background;
}

void Background::look_from(std::size_t source) {
  const View& view = sources_[source].view;
  const Eigen::Isometry3d eye_from_world = view.world_from_eye.iso.inverse();
  std::vector<Vector3d> eye_m;
  for (const Vector3d& vertex : proxy_.vertices) eye_m.emplace_back(eye_from_world * vertex);
  const Intrinsics small = shrunk(view.intrinsics);
  const std::vector<float> inverse = inverse_depths(proxy_, eye_m, small);
  for (std::size_t v = 0; v < eye_m.size(); ++v) {
    const auto at = image_of(view.intrinsics, Point<Eye>{eye_m[v]});
    if (!at || at->x() < kEdge_px || at->y() < kEdge_px || at->x() > view.intrinsics.width - 1 - kEdge_px ||
        at->y() > view.intrinsics.height - 1 - kEdge_px)
      continue;
    if (!is_unobstructed(inverse, small, *image_of(small, Point<Eye>{eye_m[v]}), eye_m[v].z())) continue;
    directions_[v * sources_.size() + source] =
        (proxy_.vertices[v] - view.world_from_eye.iso.translation()).normalized().cast<float>();
  }
}

}  // namespace telepalp::mixed
