#include "clients/ar/depth_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "proto/words/color_at.h"
#include "proto/words/demand.h"

namespace telepalp::ar {
namespace {

/// Depth [m] on a grid of at most about 400 000 pixels; 0 where nothing was measured.
struct Grid {
  int width = 0, height = 0, stride = 1;
  float pixel_rad = 0.0F;
  std::vector<float> z;

  [[nodiscard]] std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] float at(int x, int y) const noexcept {
    return x < 0 || y < 0 || x >= width || y >= height ? 0.0F : z[index(x, y)];
  }
};

/// Neighbouring depths with a smaller difference belong to one surface. A greater difference means a slope of more than
/// about 80 degrees, or a silhouette. `pixel_rad` is the angle between neighbours; Kinect v1's own steps, 2.85 mm at 1
/// m and growing with the square of depth, stay below it within the sensor's range.
float jump_m(float z, float pixel_rad) { return 0.005F + 5.0F * pixel_rad * z + 0.002F * z * z; }

Grid grid_of(const DepthImage& depth, const Intrinsics& camera) {
  Grid grid;
  while (depth.width / grid.stride * (depth.height / grid.stride) > 400'000) ++grid.stride;
  grid.pixel_rad = static_cast<float>(grid.stride / camera.fx);
  grid.width = depth.width / grid.stride;
  grid.height = depth.height / grid.stride;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      grid.z.push_back(static_cast<float>(depth.at(x * grid.stride, y * grid.stride) * depth.unit_m));
  return grid;
}

/// Mean over a square of pixels of the same surface; a pixel with too few of them is dropped.
Grid smoothed(const Grid& grid, int reach, int least_neighbours) {
  Grid out = grid;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const float z = grid.at(x, y);
      if (z <= 0.0F) continue;
      float sum = 0.0F;
      int count = 0;
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const float other = grid.at(x + dx, y + dy);
          if (other > 0.0F && std::abs(other - z) < jump_m(z, grid.pixel_rad)) {
            sum += other;
            ++count;
          }
        }
      out.z[grid.index(x, y)] = count > least_neighbours ? sum / static_cast<float>(count) : 0.0F;
    }
  return out;
}

Eigen::Vector3f place(const Grid& grid, const Intrinsics& camera, int x, int y) {
  const float z = grid.at(x, y);
  const auto u = static_cast<float>(x * grid.stride), v = static_cast<float>(y * grid.stride);
  return {(u - static_cast<float>(camera.cx)) / static_cast<float>(camera.fx) * z,
          (v - static_cast<float>(camera.cy)) / static_cast<float>(camera.fy) * z, z};
}

/// The point `(dx, dy)` steps away, or the farthest point on the way to it that is on the same surface.
Eigen::Vector3f neighbour(const Grid& grid, const Intrinsics& camera, int x, int y, int dx, int dy) {
  const float z = grid.at(x, y);
  for (int step = 3; step > 0; --step) {
    const float other = grid.at(x + step * dx, y + step * dy);
    if (other > 0.0F && std::abs(other - z) < 3.0F * jump_m(z, grid.pixel_rad))
      return place(grid, camera, x + step * dx, y + step * dy);
  }
  return place(grid, camera, x, y);
}

Eigen::Vector3f normal_at(const Grid& grid, const Intrinsics& camera, int x, int y) {
  const Eigen::Vector3f along = neighbour(grid, camera, x, y, 1, 0) - neighbour(grid, camera, x, y, -1, 0);
  const Eigen::Vector3f down = neighbour(grid, camera, x, y, 0, 1) - neighbour(grid, camera, x, y, 0, -1);
  const Eigen::Vector3f normal = down.cross(along);
  const float length = normal.norm();
  return length > 0.0F ? Eigen::Vector3f(normal / length) : Eigen::Vector3f(0.0F, 0.0F, -1.0F);
}

/// Linear colour of a point.
Eigen::Vector3f linear_color_at(const RgbdFrame& frame, int column, int row) {
  if (frame.color.rgb.empty()) return linear_from_srgb(205, 200, 194);
  const auto [r, g, b] = color_at(frame, column, row);
  return linear_from_srgb(r, g, b);
}

bool one_surface(const Grid& grid, const std::array<std::array<int, 2>, 3>& corners) {
  float least = 1e9F, most = 0.0F;
  for (const auto& [x, y] : corners) {
    const float z = grid.at(x, y);
    if (z <= 0.0F) return false;
    least = std::min(least, z);
    most = std::max(most, z);
  }
  return most - least < jump_m(least, grid.pixel_rad);
}

}  // namespace

Mesh depth_mesh(const RgbdFrame& frame) {
  demand(is_well_formed(frame.depth) && is_well_formed(frame.camera.depth), "the depth image of a mesh is well-formed");
  const Grid grid = smoothed(smoothed(grid_of(frame.depth, frame.camera.depth), 1, 3), 2, 7);
  Mesh mesh;
  mesh.vertices.reserve(grid.z.size());
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      mesh.vertices.push_back({place(grid, frame.camera.depth, x, y), normal_at(grid, frame.camera.depth, x, y),
                               linear_color_at(frame, x * grid.stride, y * grid.stride)});
  const auto add = [&](const std::array<std::array<int, 2>, 3>& corners) {
    if (!one_surface(grid, corners)) return;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = static_cast<std::uint32_t>(grid.index(corners[i][0], corners[i][1]));
    mesh.triangles.push_back(triangle);
  };
  for (int y = 0; y + 1 < grid.height; ++y)
    for (int x = 0; x + 1 < grid.width; ++x) {
      add({{{x, y}, {x, y + 1}, {x + 1, y}}});
      add({{{x + 1, y}, {x, y + 1}, {x + 1, y + 1}}});
    }
  return mesh;
}

}  // namespace telepalp::ar
