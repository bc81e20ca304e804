#include "support/models/mesh_parts.h"
#include "support/models/point_model.h"
#include "support/models/text_cursor.h"

namespace telepalp::models {
namespace {

/// The index in a word such as "3", counted from one, or "-1", counted back from the newest of `count` items.
std::optional<std::uint32_t> obj_index(std::string_view word, std::size_t count) {
  const auto number = TextCursor::number<long long>(word);
  if (!number || *number == 0) return std::nullopt;
  const long long index = *number > 0 ? *number - 1 : static_cast<long long>(count) + *number;
  if (index < 0 || index >= static_cast<long long>(count)) return std::nullopt;
  return static_cast<std::uint32_t>(index);
}

/// The content of an OBJ file while it is read.
struct ObjMesh {
  PointModel model;
  std::vector<Eigen::Vector3f> normals;  ///< in the order of the file
  std::vector<std::array<std::uint32_t, 3>> body;
  bool in_body = false;
  bool normals_used = false;
};

std::optional<Eigen::Vector3f> obj_vector(std::string_view& rest) {
  Eigen::Vector3f at;
  for (float& value : at) {
    const auto number = TextCursor::number<float>(TextCursor::word_of(rest));
    if (!number) return std::nullopt;
    value = *number;
  }
  return at;
}

/// The vertex of a corner such as "3", "3/1", "3/1/2" or "3//2". The corner's normal, if it has one, is added to the
/// vertex's normal.
std::optional<std::uint32_t> obj_corner(std::string_view word, ObjMesh& mesh) {
  const auto vertex = obj_index(word.substr(0, word.find('/')), mesh.model.points.size());
  const std::size_t last = word.rfind('/');
  if (!vertex || last == std::string_view::npos || last == word.find('/') || last + 1 == word.size()) return vertex;
  const auto normal = obj_index(word.substr(last + 1), mesh.normals.size());
  if (!normal) return std::nullopt;
  mesh.model.normals.resize(mesh.model.points.size(), Eigen::Vector3f::Zero());
  mesh.model.normals[*vertex] += mesh.normals[*normal];
  mesh.normals_used = true;
  return vertex;
}

bool obj_face(std::string_view rest, ObjMesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (std::string_view word = TextCursor::word_of(rest); !word.empty(); word = TextCursor::word_of(rest)) {
    const auto corner = obj_corner(word, mesh);
    if (!corner) return false;
    corners.push_back(*corner);
  }
  const std::size_t before = mesh.model.triangles.size();
  add_fan(corners, mesh.model);
  if (mesh.in_body)
    mesh.body.insert(mesh.body.end(), mesh.model.triangles.begin() + static_cast<std::ptrdiff_t>(before),
                     mesh.model.triangles.end());
  return true;
}

/// Removes the vertices that no triangle uses, because helper vertices must not change the model's size and middle.
PointModel only_used(const PointModel& model) {
  constexpr std::uint32_t kUnused = 0xFFFFFFFF;
  std::vector<std::uint32_t> place(model.points.size(), kUnused);
  PointModel used;
  for (const auto& triangle : model.triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& to = place[triangle[k]];
      if (to == kUnused) {
        to = static_cast<std::uint32_t>(used.points.size());
        used.points.push_back(model.points[triangle[k]]);
        if (!model.normals.empty()) used.normals.push_back(model.normals[triangle[k]]);
      }
      corners[k] = to;
    }
    used.triangles.push_back(corners);
  }
  return used;
}

}  // namespace

Result<PointModel> parse_obj(std::span<const std::byte> bytes, const std::string& name) {
  TextCursor text(bytes);
  ObjMesh mesh;
  while (!text.at_end()) {
    std::string_view rest = text.line();
    const std::string_view key = TextCursor::word_of(rest);
    bool understood = true;
    if (key == "g") mesh.in_body = TextCursor::word_of(rest) == "body";
    if (key == "v" || key == "vn") {
      const auto at = obj_vector(rest);
      understood = at.has_value();
      (key == "v" ? mesh.model.points : mesh.normals).push_back(at.value_or(Eigen::Vector3f::Zero()));
    } else if (key == "f") {
      understood = obj_face(rest, mesh);
    }
    if (!understood)
      return bad_mesh(
          name,
          "line " + std::to_string(text.line_number()) +
              " is not valid: v and vn take three numbers, f takes numbers of vertices and normals above this line");
  }
  if (mesh.model.points.empty()) return bad_mesh(name, "has no vertices");
  if (mesh.normals_used) mesh.model.normals.resize(mesh.model.points.size(), Eigen::Vector3f::Zero());
  if (mesh.model.triangles.empty() && mesh.normals.size() == mesh.model.points.size())
    mesh.model.normals = std::move(mesh.normals);
  if (!mesh.body.empty()) mesh.model.triangles = std::move(mesh.body);
  return checked_mesh(mesh.model.triangles.empty() ? std::move(mesh.model) : only_used(mesh.model), name);
}

}  // namespace telepalp::models
