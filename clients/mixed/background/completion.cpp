#include "clients/mixed/background/completion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "clients/mixed/background/blend_field.h"
#include "support/images/triangle_scan.h"

namespace telepalp::mixed {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3f;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// One source image of a triangle: the source's pixel for each pixel of the view, and the source's weight there.
struct Texture {
  const ColorImage* image;
  Matrix3f source_from_view;  ///< homography of the triangle's plane, pixels to pixels
  Vector3f weight;            ///< the source's weight at the view's pixel (x, y) is weight . (x, y, 1)
};

/// A triangle in the view.
struct Facet {
  std::array<Vector2f, 3> at;
  Vector3f inverse_depth;  ///< 1 / depth at the view's pixel (x, y) is inverse_depth . (x, y, 1) [1/m]
  std::size_t first_texture = 0;
  std::size_t end_texture = 0;
};

Matrix3d matrix_of(const Intrinsics& lens) {
  Matrix3d k;
  k << lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1;
  return k;
}

/// Draws the proxy into a view: finds the nearest triangle at each pixel, then blends its source images there.
class Painter {
 public:
  Painter(const Background& background, const View& view, const Mask& region, const CompletionSettings& settings)
      : background_(background), view_(view), region_(region), settings_(settings), box_(box_of(region)) {
    ray_ = view.world_from_eye.iso.linear() * matrix_of(view.intrinsics).inverse();
    eye_m_ = view.world_from_eye.iso.translation();
  }

  Synthesis paint() {
    Synthesis out{{view_.intrinsics.width, view_.intrinsics.height, {}}, Mask(region_.width, region_.height)};
    out.color.rgb.resize(out.known.on.size() * 3);
    if (box_.empty()) return out;
    project_vertices();
    for (const auto& triangle : background_.proxy().triangles) add_facet(triangle);
    find_nearest();
    for (int y = box_.top; y < box_.bottom; ++y)
      for (int x = box_.left; x < box_.right; ++x)
        if (region_.at(x, y)) paint_pixel(x, y, out);
    return out;
  }

 private:
  void project_vertices() {
    const Eigen::Isometry3d eye_from_world = view_.world_from_eye.iso.inverse();
    for (const Vector3d& vertex : background_.proxy().vertices) {
      const Vector3d eye_m = eye_from_world * vertex;
      image_.push_back(image_of(view_.intrinsics, Point<Eye>{eye_m}));
    }
    cameras_.resize(image_.size());
  }

  const VertexCameras& cameras(std::size_t vertex) {
    auto& chosen = cameras_[vertex];
    if (!chosen) chosen = choose_cameras(background_, vertex, eye_m_, settings_.cameras_a_vertex);
    return *chosen;
  }

  [[nodiscard]] bool meets_box(const std::array<Vector2f, 3>& at) const {
    const auto [left, right] = std::minmax({at[0].x(), at[1].x(), at[2].x()});
    const auto [top, bottom] = std::minmax({at[0].y(), at[1].y(), at[2].y()});
    return right >= static_cast<float>(box_.left) && left <= static_cast<float>(box_.right) &&
           bottom >= static_cast<float>(box_.top) && top <= static_cast<float>(box_.bottom);
  }

  void add_facet(const std::array<std::uint32_t, 3>& triangle) {
    Facet facet;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!image_[triangle[i]]) return;
      facet.at[i] = image_[triangle[i]]->cast<float>();
    }
    if (!meets_box(facet.at)) return;
    const auto& vertices = background_.proxy().vertices;
    const Vector3d& corner = vertices[triangle[0]];
    const Vector3d normal = (vertices[triangle[1]] - corner).cross(vertices[triangle[2]] - corner);
    const double distance = normal.dot(corner - eye_m_);
    if (!(std::abs(distance) > 1e-12)) return;  // the triangle has no area or is seen edge-on
    const Eigen::RowVector3d inverse_depth = normal.transpose() * ray_ / distance;
    facet.inverse_depth = inverse_depth.transpose().cast<float>();
    facet.first_texture = textures_.size();
    add_textures(triangle, facet, inverse_depth);
    facet.end_texture = textures_.size();
    if (facet.end_texture > facet.first_texture) facets_.push_back(facet);
  }

  void add_textures(const std::array<std::uint32_t, 3>& triangle, const Facet& facet,
                    const Eigen::RowVector3d& inverse_depth) {
    Matrix3f corners;
    for (Eigen::Index i = 0; i < 3; ++i) corners.row(i) << facet.at[static_cast<std::size_t>(i)].transpose(), 1.0F;
    if (!(std::abs(corners.determinant()) > 1e-6F)) return;
    const Matrix3f weight_from_corners = corners.inverse();
    std::array<std::uint16_t, 3 * kMostCameras> used{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexCameras& chosen = cameras(triangle[i]);
      for (std::size_t k = 0; k < static_cast<std::size_t>(chosen.count); ++k) {
        const Vector3f weight = chosen.weight[k] * weight_from_corners.col(static_cast<Eigen::Index>(i));
        const auto end = used.begin() + static_cast<std::ptrdiff_t>(count);
        const auto old = std::find(used.begin(), end, chosen.source[k]);
        if (old != end) {
          textures_[facet.first_texture + static_cast<std::size_t>(old - used.begin())].weight += weight;
          continue;
        }
        used[count++] = chosen.source[k];
        textures_.push_back(texture(chosen.source[k], inverse_depth, weight));
      }
    }
  }

  /// The ray of pixel p = (x, y, 1) meets the triangle's plane at eye + ray p / (inverse_depth p). The source sees this
  /// point at the homogeneous pixel K R^T ((eye - source) inverse_depth p + ray p).
  [[nodiscard]] Texture texture(std::size_t source, const Eigen::RowVector3d& inverse_depth,
                                const Vector3f& weight) const {
    const SourceImage& from = background_.sources()[source];
    const Eigen::Isometry3d& pose = from.view.world_from_eye.iso;
    const Matrix3d plane = (eye_m_ - pose.translation()) * inverse_depth + ray_;
    return {&from.color, (matrix_of(from.view.intrinsics) * pose.linear().transpose() * plane).cast<float>(), weight};
  }

  [[nodiscard]] std::size_t box_width() const { return static_cast<std::size_t>(box_.right - box_.left); }
  [[nodiscard]] std::size_t in_box_index(int x, int y) const {
    return static_cast<std::size_t>(y - box_.top) * box_width() + static_cast<std::size_t>(x - box_.left);
  }

  void find_nearest() {
    nearest_.assign(static_cast<std::size_t>(box_.bottom - box_.top) * box_width(), -1);
    std::vector<float> inverse(nearest_.size(), 0.0F);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Facet& facet = facets_[f];
      images::scan_triangle(
          facet.at[0], facet.at[1], facet.at[2], region_.width, region_.height, [&](int x, int y, float, float, float) {
            if (!region_.at(x, y)) return;  // the region lies within the box, so the index below is valid
            const std::size_t pixel = in_box_index(x, y);
            const float here = facet.inverse_depth.dot(Vector3f(static_cast<float>(x), static_cast<float>(y), 1.0F));
            if (here <= inverse[pixel]) return;
            inverse[pixel] = here;
            nearest_[pixel] = static_cast<std::int32_t>(f);
          });
    }
  }

  void paint_pixel(int x, int y, Synthesis& out) const {
    const std::size_t pixel = region_.index(x, y);
    const std::int32_t nearest = nearest_[in_box_index(x, y)];
    if (nearest < 0) return;
    const Facet& facet = facets_[static_cast<std::size_t>(nearest)];
    const Vector3f at(static_cast<float>(x), static_cast<float>(y), 1.0F);
    Vector3f sum = Vector3f::Zero();
    float weights = 0.0F;
    for (std::size_t t = facet.first_texture; t < facet.end_texture; ++t) {
      const Texture& texture = textures_[t];
      const float weight = texture.weight.dot(at);
      if (weight > 1e-3F) add_sample(texture, at, weight, sum, weights);
    }
    if (weights <= 0.0F) return;
    out.known.on[pixel] = 1;
    for (std::size_t c = 0; c < 3; ++c)
      out.color.rgb[3 * pixel + c] =
          static_cast<std::uint8_t>(std::min(sum[static_cast<Eigen::Index>(c)] / weights + 0.5F, 255.0F));
  }

  static void add_sample(const Texture& texture, const Vector3f& at, float weight, Vector3f& sum, float& weights) {
    const Vector3f h = texture.source_from_view * at;
    if (!(h.z() > 0.0F)) return;
    const float u = h.x() / h.z(), v = h.y() / h.z();
    const ColorImage& image = *texture.image;
    if (!(u >= 0.0F && v >= 0.0F && u < static_cast<float>(image.width - 1) &&
          v < static_cast<float>(image.height - 1)))
      return;
    const int left = static_cast<int>(u), top = static_cast<int>(v);
    const float right_share = u - static_cast<float>(left), low_share = v - static_cast<float>(top);
    const std::uint8_t* const upper =
        image.rgb.data() +
        3 * (static_cast<std::size_t>(top) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(left));
    const std::uint8_t* const lower = upper + 3 * static_cast<std::size_t>(image.width);
    const float a = (1.0F - right_share) * (1.0F - low_share) * weight, b = right_share * (1.0F - low_share) * weight;
    const float c = (1.0F - right_share) * low_share * weight, d = right_share * low_share * weight;
    for (int k = 0; k < 3; ++k)
      sum[k] += a * static_cast<float>(upper[k]) + b * static_cast<float>(upper[k + 3]) +
                c * static_cast<float>(lower[k]) + d * static_cast<float>(lower[k + 3]);
    weights += weight;
  }

  const Background& background_;
  const View& view_;
  const Mask& region_;
  const CompletionSettings& settings_;
  const Box box_;
  Matrix3d ray_;  ///< times (x, y, 1): direction of a pixel's ray in the world's frame, 1 long along the camera's z
  Vector3d eye_m_;
  std::vector<std::optional<Eigen::Vector2d>> image_;
  std::vector<std::optional<VertexCameras>> cameras_;
  std::vector<Facet> facets_;
  std::vector<Texture> textures_;
  std::vector<std::int32_t> nearest_;  ///< the facet at each pixel of the box; -1: none
};

}  // namespace

Synthesis synthesise(const Background& background, const View& view, const Mask& region,
                     const CompletionSettings& settings) {
  return Painter(background, view, region, settings).paint();
}

Mask with_ring(const Mask& mask, int ring_px) {
  const std::vector<std::uint8_t> distance = distance_outside(mask, ring_px);
  Mask out(mask.width, mask.height);
  for (std::size_t i = 0; i < distance.size(); ++i) out.on[i] = distance[i] <= 3 * ring_px ? 1 : 0;
  return out;
}

void paint_background(ColorImage& image, const Synthesis& background, const Mask& emptied, int ring_px) {
  const std::vector<std::uint8_t> distance = distance_outside(emptied, ring_px);
  const int width = 3 * (ring_px + 1);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const int share = width - distance[i];  // the background has weight share / width
    if (share <= 0 || background.known.on[i] == 0) continue;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      image.rgb[c] = static_cast<std::uint8_t>(
          (share * background.color.rgb[c] + (width - share) * image.rgb[c] + width / 2) / width);
  }
}

std::optional<double> ring_difference(const ColorImage& live, const Synthesis& background, const Mask& emptied,
                                      int ring_px) {
  const std::vector<std::uint8_t> distance = distance_outside(emptied, ring_px);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] == 0 || distance[i] > 3 * ring_px || background.known.on[i] == 0) continue;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) sum += std::abs(int{live.rgb[c]} - int{background.color.rgb[c]});
    count += 3;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

}  // namespace telepalp::mixed
