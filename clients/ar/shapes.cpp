#include "clients/ar/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace telepalp::ar {
namespace {

constexpr int kAround = 48;
constexpr int kRings = 32;
constexpr float kPi = std::numbers::pi_v<float>;
const Eigen::Vector3f kWhite = Eigen::Vector3f::Ones();

/// Adds a disc of outward normal `normal`.
void cap(Mesh& mesh, const Eigen::Vector3f& centre, const Eigen::Vector3f& normal, float radius,
         const std::vector<Eigen::Vector3f>& spokes) {
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({centre, normal, kWhite});
  for (const Eigen::Vector3f& spoke : spokes) mesh.vertices.push_back({centre + radius * spoke, normal, kWhite});
  for (std::uint32_t i = 0; i < kAround; ++i) mesh.triangles.push_back({middle, middle + 1 + i, middle + 2 + i});
}

}  // namespace

Mesh ball(const Eigen::Vector3f& centre, float radius_m) {
  Mesh mesh;
  for (int ring = 0; ring <= kRings; ++ring)
    for (int step = 0; step <= kAround; ++step) {
      const float polar = kPi * static_cast<float>(ring) / kRings;
      const float around = 2.0F * kPi * static_cast<float>(step) / kAround;
      const Eigen::Vector3f normal(std::sin(polar) * std::cos(around), std::cos(polar),
                                   std::sin(polar) * std::sin(around));
      mesh.vertices.push_back({centre + radius_m * normal, normal, kWhite});
    }
  const std::uint32_t row = kAround + 1;
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t step = 0; step < kAround; ++step) {
      const std::uint32_t at = ring * row + step;
      mesh.triangles.push_back({at, at + 1, at + row});
      mesh.triangles.push_back({at + 1, at + row + 1, at + row});
    }
  return mesh;
}

Mesh frustum(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float from_radius_m, float to_radius_m) {
  const float length = (to - from).norm();
  if (!(length > 1e-6F)) return {};
  const Eigen::Vector3f along = (to - from) / length;
  const Eigen::Vector3f side = along.unitOrthogonal(), other = along.cross(side);
  std::vector<Eigen::Vector3f> spokes;
  for (int step = 0; step <= kAround; ++step) {
    const float angle = 2.0F * kPi * static_cast<float>(step) / kAround;
    spokes.push_back(std::cos(angle) * side + std::sin(angle) * other);
  }
  Mesh mesh;
  for (const Eigen::Vector3f& spoke : spokes) {
    const Eigen::Vector3f normal = (spoke * length + along * (from_radius_m - to_radius_m)).normalized();
    mesh.vertices.push_back({from + from_radius_m * spoke, normal, kWhite});
    mesh.vertices.push_back({to + to_radius_m * spoke, normal, kWhite});
  }
  for (std::uint32_t i = 0; i < 2 * kAround; i += 2) {
    mesh.triangles.push_back({i, i + 1, i + 2});
    mesh.triangles.push_back({i + 1, i + 3, i + 2});
  }
  cap(mesh, from, -along, from_radius_m, spokes);
  cap(mesh, to, along, to_radius_m, spokes);
  return mesh;
}

Mesh arrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius_m) {
  const float length = (to - from).norm();
  if (!(length > 1e-6F)) return {};
  const float head = std::min(length, 5.0F * radius_m);
  const Eigen::Vector3f neck = to - (to - from) * (head / length);
  Mesh mesh = frustum(from, neck, radius_m, radius_m);
  append(mesh, frustum(neck, to, 2.4F * radius_m, 0.02F * radius_m));
  return mesh;
}

}  // namespace telepalp::ar
