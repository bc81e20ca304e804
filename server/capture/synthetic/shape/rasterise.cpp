#include "server/capture/synthetic/shape/rasterise.h"

#include "support/images/triangle_scan.h"

namespace telepalp::capture {
namespace {

constexpr float kShapeFactor = 0.75F;
constexpr float kNearestCorner_m = 0.05F;  // a triangle that is nearer than this is not drawn

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
  const auto nearer = [&](int u, int v, float wa, float wb, float wc) {
    Eigen::Vector3f w{wa / corners[0].at.z(), wb / corners[1].at.z(), wc / corners[2].at.z()};
    w /= w.sum();  // perspective: weights that are linear in space, not in the image
    float& nearest =
        depth[static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(u)];
    const float z = curved_depth(corners, w);
    if (nearest <= 0.0F || z < nearest) nearest = z;
  };
  images::scan_triangle(corners[0].pixel, corners[1].pixel, corners[2].pixel, camera.width, camera.height, nearer);
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
      in_front = in_front && at.z() > kNearestCorner_m;
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
