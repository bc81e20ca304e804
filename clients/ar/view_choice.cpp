#include "clients/ar/view_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace telepalp::ar {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0F;

/// A coarse z-buffer of a mesh's vertices: the nearest depth in each cell [m]; 0: none.
class CoarseDepth {
 public:
  CoarseDepth(const ViewCamera& camera, const Mesh& mesh) : camera_(camera), nearest_(kColumns * kRows, 0.0F) {
    for (const Mesh::Vertex& vertex : mesh.vertices) {
      const std::optional<std::size_t> cell = cell_of(vertex.at);
      if (!cell) continue;
      float& nearest = nearest_[*cell];
      const float depth = depth_of(vertex.at);
      nearest = nearest > 0.0F ? std::min(nearest, depth) : depth;
    }
  }

  [[nodiscard]] bool is_hidden(const Eigen::Vector3f& at) const {
    constexpr float kBehind_m = 0.03F;
    const std::optional<std::size_t> cell = cell_of(at);
    return !cell || depth_of(at) > nearest_[*cell] + kBehind_m;
  }

  /// Share of the filled cells in the middle half of the picture.
  [[nodiscard]] float filled() const {
    std::size_t filled = 0, all = 0;
    for (std::size_t row = kRows / 4; row < 3 * kRows / 4; ++row)
      for (std::size_t column = kColumns / 4; column < 3 * kColumns / 4; ++column, ++all)
        filled += nearest_[row * kColumns + column] > 0.0F ? 1U : 0U;
    return static_cast<float>(filled) / static_cast<float>(all);
  }

 private:
  static constexpr std::size_t kColumns = 64, kRows = 48;

  [[nodiscard]] float depth_of(const Eigen::Vector3f& at) const {
    return camera_.view_from_scene.row(2).dot(at - camera_.eye);
  }
  [[nodiscard]] std::optional<std::size_t> cell_of(const Eigen::Vector3f& at) const {
    const Projected place = camera_.project(at);
    const float column = place.x * static_cast<float>(kColumns) / static_cast<float>(camera_.width_px);
    const float row = place.y * static_cast<float>(kRows) / static_cast<float>(camera_.height_px);
    const bool inside = place.visible && column >= 0.0F && row >= 0.0F && column < static_cast<float>(kColumns) &&
                        row < static_cast<float>(kRows);
    if (!inside) return std::nullopt;
    return static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
  }

  const ViewCamera& camera_;
  std::vector<float> nearest_;
};

ViewCamera tilted(const Eigen::Vector3f& target, float turn_rad, float tilt_rad, float distance_m, int width_px,
                  int height_px) {
  const Eigen::Matrix3f tilt =
      (Eigen::AngleAxisf(turn_rad, Eigen::Vector3f::UnitY()) * Eigen::AngleAxisf(tilt_rad, Eigen::Vector3f::UnitX()))
          .toRotationMatrix();
  const Eigen::Vector3f away = tilt * Eigen::Vector3f(0.0F, 0.0F, -1.0F);
  return look_at(target + distance_m * away, target, tilt * Eigen::Vector3f(0.0F, -1.0F, 0.0F), 40.0F * kDegree,
                 width_px, height_px);
}

}  // namespace

ViewQuality quality_of(const ViewCamera& camera, const Mesh& body, const Eigen::Vector3f& target) {
  constexpr float kAround_m = 0.1F;  // a hand's breadth
  const CoarseDepth depth(camera, body);
  std::size_t around = 0, seen = 0;
  float facing = 0.0F;
  for (const Mesh::Vertex& vertex : body.vertices) {
    if ((vertex.at - target).squaredNorm() > kAround_m * kAround_m) continue;
    ++around;
    seen += depth.is_hidden(vertex.at) ? 0U : 1U;
    facing += std::max(0.0F, vertex.normal.dot((camera.eye - vertex.at).normalized()));
  }
  if (around == 0) return {.seen = depth.is_hidden(target) ? 0.0F : 1.0F, .facing = 1.0F, .filled = depth.filled()};
  const auto count = static_cast<float>(around);
  return {.seen = static_cast<float>(seen) / count, .facing = facing / count, .filled = depth.filled()};
}

ViewCamera chosen_view(const Mesh& body, const Eigen::Vector3f& target, float distance_m, int width_px, int height_px) {
  constexpr struct {
    float turn_deg, tilt_deg;
  } kDirections[] = {{-28, 42}, {28, 42}, {-20, 24}, {20, 24}, {-12, 10}, {0, 0}};
  std::optional<ViewCamera> best;
  float best_score = -1.0F;
  for (const auto& [turn_deg, tilt_deg] : kDirections) {
    const ViewCamera camera = tilted(target, turn_deg * kDegree, tilt_deg * kDegree, distance_m, width_px, height_px);
    const ViewQuality quality = quality_of(camera, body, target);
    if (quality.is_good()) return camera;
    if (quality.score() <= best_score) continue;
    best = camera;
    best_score = quality.score();
  }
  return *best;
}

}  // namespace telepalp::ar
