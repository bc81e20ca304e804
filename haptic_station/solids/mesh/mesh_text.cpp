#include <array>
#include <cstdio>

#include "haptic_station/solids/solid_mesh.h"

namespace telepalp::solids {
namespace {

template <class... Numbers>
void add_line(std::string& text, const char* format, Numbers... numbers) {
  std::array<char, 96> line{};
  std::snprintf(line.data(), line.size(), format, numbers...);
  text += line.data();
}

}  // namespace

std::string to_ply(const SolidMesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& p : mesh.points) add_line(text, "%.7g %.7g %.7g\n", p.x(), p.y(), p.z());
  for (const auto& t : mesh.triangles) add_line(text, "3 %u %u %u\n", t[0], t[1], t[2]);
  return text;
}

std::string to_obj(const SolidMesh& mesh) {
  std::string text;
  for (const Eigen::Vector3d& p : mesh.points) add_line(text, "v %.7g %.7g %.7g\n", p.x(), p.y(), p.z());
  for (const auto& t : mesh.triangles) add_line(text, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

}  // namespace telepalp::solids
