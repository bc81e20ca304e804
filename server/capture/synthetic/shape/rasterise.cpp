#include "server/capture/synthetic/shape/rasterise.h"

#include <algorithm>
#include <cmath>

namespace telepalp::capture {
namespace {

constexpr float kShapeFactor = 0.75F;
constexpr float kNearest_m = 0.05F;  // a triangle that is nearer than this is not drawn

struct Corner {
  Eigen::Vector3f at;
  Eigen::Vector3f normal;
  Eigen::Vector2f pixel;
};

/// Depth of the curved triangle at barycentric weights `w`.
float curved_depth(const std::array<Corner, 3>& corners, const Eigen::Vector3f& w) {
  const Eigen::Vector3f flat = w[0] * corners[0].at + w[1] * corners[1].at + w[2] * corners[2].at;
  float bulged_z = 0.0F;
  for (int i = 0; i < 3; ++i) {
    const Corner& corner = corners[static_cast<std::size_t>(i)];
    bulged_z += w[i] * (flat.z() - (flat - corner.at).dot(corner.normal) * corner.normal.z());
  }
  return (1.0F - kShapeFactor) * flat.z() + kShapeFactor * bulged_z;
}

void draw(const std::array<Corner, 3>& corners, const Intrinsics& camera, std::vector<float>& depth) {
  const Eigen::Vector2f &a = corners[0].pixel, &b = corners[1].pixel, &c = corners[2].pixel;
  const float area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
  if (std::abs(area) < 1e-6F) return;
  const auto first = [](float least, int last) { return std::clamp(static_cast<int>(std::ceil(least)), 0, last); };
  const auto end = [](float most, int last) {
    return std::clamp(static_cast<int>(std::floor(most)), -1, last - 1) + 1;
  };
  const int u0 = first(std::min({a.x(), b.x(), c.x()}), camera.width);
  const int u1 = end(std::max({a.x(), b.x(), c.x()}), camera.width);
  const int v0 = first(std::min({a.y(), b.y(), c.y()}), camera.height);
  const int v1 = end(std::max({a.y(), b.y(), c.y()}), camera.height);
  for (int v = v0; v < v1; ++v)
    for (int u = u0; u < u1; ++u) {
      const Eigen::Vector2f p{static_cast<float>(u), static_cast<float>(v)};
      const float wb = ((p.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (p.y() - a.y())) / area;
      const float wc = ((b.x() - a.x()) * (p.y() - a.y()) - (p.x() - a.x()) * (b.y() - a.y())) / area;
      if (wb < 0.0F || wc < 0.0F || wb + wc > 1.0F) continue;
      Eigen::Vector3f w{(1.0F - wb - wc) / corners[0].at.z(), wb / corners[1].at.z(), wc / corners[2].at.z()};
      w /= w.sum();  // perspective: weights that are linear in space, not in the image
      float& nearest =
          depth[static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(u)];
      const float z = curved_depth(corners, w);
      if (nearest <= 0.0F || z < nearest) nearest = z;
    }
}

}  // namespace

std::vector<float> rasterise(const TriangleMesh& mesh, const Intrinsics& camera) {
  const std::vector<Eigen::Vector3f> normals = vertex_normals(mesh);
  std::vector<float> depth(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height), 0.0F);
  for (const auto& triangle : mesh.triangles) {
    std::array<Corner, 3> corners;
    bool in_front = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3f& at = mesh.vertices[triangle[i]];
      in_front = in_front && at.z() > kNearest_m;
      corners[i] = {at,
                    normals[triangle[i]],
                    {static_cast<float>(camera.fx) * at.x() / at.z() + static_cast<float>(camera.cx),
                     static_cast<float>(camera.fy) * at.y() / at.z() + static_cast<float>(camera.cy)}};
    }
    if (in_front) draw(corners, camera, depth);
  }
  return depth;
}

}  // namespace telepalp::capture
