#include "clients/ar/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clients/ar/scan.h"
#include "proto/words/demand.h"

namespace telepalp::ar {
namespace {

/// A visible point of a surface.
struct Fragment {
  Eigen::Vector3f at, normal, color;
};

Eigen::Vector3f shaded(const Fragment& fragment, const Eigen::Vector3f& to_eye, const Lights& lights, float lit,
                       float shine) {
  const float facing_key = std::max(0.0F, fragment.normal.dot(lights.key));
  const float facing_up = 0.5F + 0.5F * fragment.normal.dot(lights.up);
  const float diffuse = 0.30F + 0.32F * facing_up + 0.62F * facing_key * lit;
  const Eigen::Vector3f half = (lights.key + to_eye).normalized();
  const float highlight = shine * lit * std::pow(std::max(0.0F, fragment.normal.dot(half)), 40.0F);
  return diffuse * fragment.color + Eigen::Vector3f::Constant(highlight);
}

}  // namespace

Canvas::Canvas(int width_px, int height_px, const Eigen::Vector3f& top, const Eigen::Vector3f& bottom)
    : width_(width_px * kSamples), height_(height_px * kSamples) {
  static_assert(kMaxImageSide == 4096, "the text below names it");
  demand(width_px > 0 && height_px > 0 && width_px <= kMaxImageSide && height_px <= kMaxImageSide,
         "a picture is 1 to 4096 pixels wide and high");
  depth_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                std::numeric_limits<float>::infinity());
  light_.reserve(depth_.size());
  for (int y = 0; y < height_; ++y) {
    const float down = static_cast<float>(y) / static_cast<float>(height_);
    light_.insert(light_.end(), static_cast<std::size_t>(width_), top + down * (bottom - top));
  }
}

ViewCamera Canvas::supersampled(ViewCamera camera) const noexcept {
  camera.width_px *= kSamples;
  camera.height_px *= kSamples;
  camera.focal_px *= kSamples;
  return camera;
}

void Canvas::draw(const Mesh& mesh, const ViewCamera& camera_px, const Lights& lights, const ShadowMap& shadow,
                  const Paint& paint) {
  const ViewCamera camera = supersampled(camera_px);
  demand(camera.width_px == width_ && camera.height_px == height_,
         "the camera's image and the canvas have the same size");
  std::vector<Projected> projected;
  projected.reserve(mesh.vertices.size());
  for (const Mesh::Vertex& vertex : mesh.vertices) projected.push_back(camera.project(vertex.at));

  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Projected &pa = projected[ia], &pb = projected[ib], &pc = projected[ic];
    const Mesh::Vertex &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
    scan(pa, pb, pc, width_, height_, [&](int x, int y, float wa, float wb, float wc) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      const float depth = wa * pa.depth + wb * pb.depth + wc * pc.depth;
      const bool in_front = depth < depth_[pixel];
      if (!in_front && paint.behind <= 0.0F) return;
      // The weights are linear in the image instead of in space. Triangles are a few pixels wide, so the difference is
      // invisible.
      Fragment fragment{wa * a.at + wb * b.at + wc * c.at, (wa * a.normal + wb * b.normal + wc * c.normal).normalized(),
                        wa * a.color + wb * b.color + wc * c.color};
      const Eigen::Vector3f to_eye = (camera.eye - fragment.at).normalized();
      const float facing = fragment.normal.dot(to_eye);
      if (facing < 0.0F) {
        if (!paint.two_sided) return;
        fragment.normal = -fragment.normal;
      }
      const float lit = paint.takes_shadow ? shadow.light_at(fragment.at) : 1.0F;
      const float grazing = 1.0F - std::abs(facing);
      const float alpha =
          std::min(1.0F, in_front ? paint.opacity + paint.rim * grazing * grazing : paint.behind * (1.0F + grazing));
      const Eigen::Vector3f color = shaded(fragment, to_eye, lights, lit, paint.shine);
      light_[pixel] += alpha * (color - light_[pixel]);
      if (in_front && paint.opacity >= 1.0F) depth_[pixel] = depth;
    });
  }
}

ColorImage Canvas::resolved() const {
  ColorImage image{width_ / kSamples, height_ / kSamples, {}};
  image.rgb.reserve(light_.size() / (std::size_t{kSamples} * kSamples) * 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int sample = 0; sample < kSamples * kSamples; ++sample) {
        const int sx = x * kSamples + sample % kSamples, sy = y * kSamples + sample / kSamples;
        sum += light_[static_cast<std::size_t>(sy) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(sx)];
      }
      for (int channel = 0; channel < 3; ++channel)
        image.rgb.push_back(srgb_from_linear(sum[channel] / (kSamples * kSamples)));
    }
  return image;
}

}  // namespace telepalp::ar
