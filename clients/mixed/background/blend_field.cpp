#include "clients/mixed/background/blend_field.h"

#include <algorithm>
#include <cmath>

namespace telepalp::mixed {

VertexCameras choose_cameras(const Background& background, std::size_t vertex, const Eigen::Vector3d& eye_m,
                             int cameras) {
  const Eigen::Vector3f direction = (background.proxy().vertices[vertex] - eye_m).normalized().cast<float>();
  // The best sources so far, best first. One more than `cameras` is kept: its angle scales the weights.
  std::array<float, kMostCameras + 1> cosine{};
  std::array<std::uint16_t, kMostCameras + 1> source{};
  int found = 0;
  const int kept = std::clamp(cameras, 1, kMostCameras) + 1;
  for (std::size_t s = 0; s < background.sources().size(); ++s) {
    const float value = background.direction(vertex, s).dot(direction);
    if (value <= 0.0F) continue;
    int place = std::min(found, kept);
    while (place > 0 && cosine[static_cast<std::size_t>(place - 1)] < value) --place;
    if (place >= kept) continue;
    for (int i = std::min(found, kept - 1); i > place; --i) {
      cosine[static_cast<std::size_t>(i)] = cosine[static_cast<std::size_t>(i - 1)];
      source[static_cast<std::size_t>(i)] = source[static_cast<std::size_t>(i - 1)];
    }
    cosine[static_cast<std::size_t>(place)] = value;
    source[static_cast<std::size_t>(place)] = static_cast<std::uint16_t>(s);
    found = std::min(found + 1, kept);
  }
  VertexCameras chosen;
  chosen.count = std::min(found, kept - 1);
  const auto angle = [&](int i) { return std::acos(std::min(1.0F, cosine[static_cast<std::size_t>(i)])); };
  const float limit = found > chosen.count ? angle(chosen.count) : 1.01F * angle(std::max(chosen.count - 1, 0)) + 1e-3F;
  float sum = 0.0F;
  for (int i = 0; i < chosen.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    chosen.source[k] = source[k];
    chosen.weight[k] = chosen.count == 1 ? 1.0F : 1.0F - angle(i) / std::max(limit, 1e-6F) + 1e-4F;
    sum += chosen.weight[k];
  }
  for (float& weight : chosen.weight) weight = sum > 0.0F ? weight / sum : 0.0F;
  return chosen;
}

}  // namespace telepalp::mixed
