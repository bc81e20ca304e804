#include "clients/ar/mesh.h"

#include <algorithm>
#include <cmath>

namespace telepalp::ar {

void append(Mesh& mesh, const Mesh& more) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& [a, b, c] : more.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

Mesh moved(Mesh mesh, const Eigen::Matrix3f& rotation, const Eigen::Vector3f& translation) {
  for (Mesh::Vertex& vertex : mesh.vertices) {
    vertex.at = rotation * vertex.at + translation;
    vertex.normal = rotation * vertex.normal;
  }
  return mesh;
}

Mesh painted(Mesh mesh, const Eigen::Vector3f& color) {
  for (Mesh::Vertex& vertex : mesh.vertices) vertex.color = color;
  return mesh;
}

Eigen::Vector3f linear_from_srgb(int red, int green, int blue) noexcept {
  const auto linear = [](int value) { return std::pow(static_cast<float>(value) / 255.0F, 2.2F); };
  return {linear(red), linear(green), linear(blue)};
}

std::uint8_t srgb_from_linear(float value) noexcept {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::pow(std::clamp(value, 0.0F, 1.0F), 1.0F / 2.2F)));
}

}  // namespace telepalp::ar
