#include <cstring>

#include "haptic_station/surface/point_model.h"
#include "haptic_station/surface/text_cursor.h"

namespace telepalp::surface {
namespace {

struct Property {
  std::string name;
  std::size_t bytes = 4;
  bool real = true;
  std::size_t count_bytes = 0;  ///< of a list's length; 0: not a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

Error bad(const std::string& name, const std::string& what) {
  return {.what = what, .where = name, .fix = "export the model anew, as ascii or binary_little_endian PLY, or OBJ"};
}

std::optional<Property> type_of(std::string_view word) {
  if (word == "float" || word == "float32") return Property{.name = {}, .bytes = 4, .real = true};
  if (word == "double" || word == "float64") return Property{.name = {}, .bytes = 8, .real = true};
  const bool one = word == "char" || word == "uchar" || word == "int8" || word == "uint8";
  const bool two = word == "short" || word == "ushort" || word == "int16" || word == "uint16";
  const bool four = word == "int" || word == "uint" || word == "int32" || word == "uint32";
  if (!one && !two && !four) return std::nullopt;
  return Property{.name = {}, .bytes = one ? 1U : (two ? 2U : 4U), .real = false};
}

/// Reads numbers one after another, from text or from little-endian bytes; fails for good at the end of the data.
class Numbers {
 public:
  Numbers(std::span<const std::byte> bytes, bool ascii) : bytes_(bytes), text_(bytes), ascii_(ascii) {}
  [[nodiscard]] bool ok() const noexcept { return ok_; }

  double next(std::size_t bytes, bool real) {
    if (ascii_) {
      const auto value = TextCursor::number<double>(text_.word());
      ok_ = ok_ && value.has_value();
      return value.value_or(0.0);
    }
    if (!ok_ || bytes_.size() - at_ < bytes) {
      ok_ = false;
      return 0.0;
    }
    const std::byte* from = &bytes_[at_];
    at_ += bytes;
    return real ? (bytes == 4 ? as<float>(from) : as<double>(from))
                : (bytes == 1   ? as<std::uint8_t>(from)
                   : bytes == 2 ? as<std::uint16_t>(from)
                                : as<std::uint32_t>(from));
  }

 private:
  template <class T>
  static double as(const std::byte* from) {
    T value{};
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
  }
  std::span<const std::byte> bytes_;
  TextCursor text_;
  std::size_t at_ = 0;
  bool ascii_;
  bool ok_ = true;
};

struct PlyHeader {
  std::vector<Element> elements;
  bool ascii = true;
  std::size_t data_at = 0;
};

Result<PlyHeader> parse_ply_header(std::span<const std::byte> bytes, const std::string& name) {
  TextCursor text(bytes);
  if (text.line() != "ply") return bad(name, "is not a PLY file");
  PlyHeader header;
  while (!text.at_end()) {
    std::string_view rest = text.line();
    const std::string_view key = TextCursor::word_of(rest);
    const std::string_view first = TextCursor::word_of(rest);
    if (key == "format") {
      header.ascii = first == "ascii";
      if (!header.ascii && first != "binary_little_endian") return bad(name, "has format " + std::string(first));
    } else if (key == "element") {
      const auto count = TextCursor::number<std::size_t>(TextCursor::word_of(rest));
      if (!count || *count > 3 * kMostModelPoints || *count > bytes.size())
        return bad(name, "promises more of '" + std::string(first) + "' than it has bytes for");
      header.elements.push_back({.name = std::string(first), .count = *count, .properties = {}});
    } else if (key == "property" && !header.elements.empty()) {
      std::optional<Property> property;
      if (first == "list") {
        const auto length = type_of(TextCursor::word_of(rest));
        property = type_of(TextCursor::word_of(rest));
        if (property && length) property->count_bytes = length->bytes;
        if (!length) property.reset();
      } else {
        property = type_of(first);
      }
      if (!property) return bad(name, "has a property of an unknown type");
      property->name = TextCursor::word_of(rest);
      header.elements.back().properties.push_back(*property);
    } else if (key == "end_header") {
      header.data_at = text.offset();
      return header;
    }
  }
  return bad(name, "has no end_header");
}

Result<void> read_vertices(const Element& element, Numbers& numbers, PointModel& model, const std::string& name) {
  const char* wanted[6] = {"x", "y", "z", "nx", "ny", "nz"};
  std::array<float, 6> values{};
  std::array<bool, 6> present{};
  for (const Property& property : element.properties)
    for (std::size_t k = 0; k < 6; ++k) present[k] = present[k] || property.name == wanted[k];
  if (!present[0] || !present[1] || !present[2]) return bad(name, "has vertices without x, y and z");
  const bool with_normals = present[3] && present[4] && present[5];
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (property.count_bytes != 0) return bad(name, "has a list in its vertices, which is not read");
      const auto value = static_cast<float>(numbers.next(property.bytes, property.real));
      for (std::size_t k = 0; k < 6; ++k)
        if (property.name == wanted[k]) values[k] = value;
    }
    if (!numbers.ok()) return bad(name, "ends at vertex " + std::to_string(i) + " of " + std::to_string(element.count));
    model.points.emplace_back(values[0], values[1], values[2]);
    if (with_normals) model.normals.emplace_back(values[3], values[4], values[5]);
  }
  return {};
}

void add_fan(const std::vector<std::uint32_t>& corners, PointModel& model) {
  for (std::size_t k = 2; k < corners.size(); ++k) model.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

/// Faces, or an element that is skipped.
Result<void> read_lists(const Element& element, Numbers& numbers, PointModel& model, const std::string& name) {
  constexpr double kMostCorners = 1000.0;
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < element.count; ++i)
    for (const Property& property : element.properties) {
      const double length = property.count_bytes == 0 ? 1.0 : numbers.next(property.count_bytes, false);
      if (!numbers.ok() || !(length >= 0.0 && length <= kMostCorners))
        return bad(name, "is damaged at " + element.name + " " + std::to_string(i));
      corners.clear();
      for (int k = 0; k < static_cast<int>(length); ++k)
        corners.push_back(static_cast<std::uint32_t>(std::max(0.0, numbers.next(property.bytes, property.real))));
      if (!numbers.ok()) return bad(name, "ends at " + element.name + " " + std::to_string(i));
      if (element.name == "face" && property.count_bytes != 0 && property.name.starts_with("vertex_ind"))
        add_fan(corners, model);
    }
  return {};
}

Result<PointModel> checked(PointModel model, const std::string& name) {
  for (const auto& triangle : model.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= model.points.size())
        return bad(name, "has a face that names vertex " + std::to_string(corner) + " of " +
                             std::to_string(model.points.size()));
  if (model.points.size() > kMostModelPoints) return bad(name, "has more than 20 million points");
  return model;
}

/// "3" or "-1": counted from one, or back from the newest of `count`.
std::optional<std::uint32_t> obj_index(std::string_view word, std::size_t count) {
  const auto number = TextCursor::number<long long>(word);
  if (!number || *number == 0) return std::nullopt;
  const long long index = *number > 0 ? *number - 1 : static_cast<long long>(count) + *number;
  if (index < 0 || index >= static_cast<long long>(count)) return std::nullopt;
  return static_cast<std::uint32_t>(index);
}

/// What an OBJ holds, while it is read.
struct ObjMesh {
  PointModel model;
  std::vector<Eigen::Vector3f> normals;  ///< as they are listed
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

/// A corner, "3", "3/1", "3/1/2" or "3//2": its vertex; a normal that it names is added to the vertex's.
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

/// Without the vertices that no triangle has: helpers must not count for the model's size and middle.
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

Result<PointModel> parse_ply(std::span<const std::byte> bytes, const std::string& name) {
  const Result<PlyHeader> header = parse_ply_header(bytes, name);
  if (!header) return header.error();
  PointModel model;
  Numbers numbers(bytes.subspan(header->data_at), header->ascii);
  for (const Element& element : header->elements) {
    const Result<void> read = element.name == "vertex" ? read_vertices(element, numbers, model, name)
                                                       : read_lists(element, numbers, model, name);
    if (!read) return read.error();
  }
  return checked(std::move(model), name);
}

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
    if (!understood) return bad(name, "line " + std::to_string(text.line_number()) + " is not understood");
  }
  if (mesh.model.points.empty()) return bad(name, "has no vertices");
  if (mesh.normals_used) mesh.model.normals.resize(mesh.model.points.size(), Eigen::Vector3f::Zero());
  if (mesh.model.triangles.empty() && mesh.normals.size() == mesh.model.points.size())
    mesh.model.normals = std::move(mesh.normals);
  if (!mesh.body.empty()) mesh.model.triangles = std::move(mesh.body);
  return checked(mesh.model.triangles.empty() ? std::move(mesh.model) : only_used(mesh.model), name);
}

}  // namespace telepalp::surface
