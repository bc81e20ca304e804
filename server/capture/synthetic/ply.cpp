#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "server/capture/synthetic/mesh.h"

namespace telepalp::server {
namespace {

constexpr std::uintmax_t kMaxPlyBytes = 256U << 20U;
constexpr std::size_t kMaxPolygonCorners = 64;

enum class Scalar { I8, U8, I16, U16, I32, U32, F32, F64 };

std::optional<Scalar> scalar_named(std::string_view name) {
  if (name == "char" || name == "int8") return Scalar::I8;
  if (name == "uchar" || name == "uint8") return Scalar::U8;
  if (name == "short" || name == "int16") return Scalar::I16;
  if (name == "ushort" || name == "uint16") return Scalar::U16;
  if (name == "int" || name == "int32") return Scalar::I32;
  if (name == "uint" || name == "uint32") return Scalar::U32;
  if (name == "float" || name == "float32") return Scalar::F32;
  if (name == "double" || name == "float64") return Scalar::F64;
  return std::nullopt;
}

constexpr std::size_t bytes_of(Scalar scalar) {
  constexpr std::size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<std::size_t>(scalar)];
}

struct Property {
  std::string name;
  Scalar scalar = Scalar::F32;
  std::optional<Scalar> count;  // a list when present
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};
struct Header {
  bool ascii = false;
  std::vector<Element> elements;
  std::size_t bytes = 0;
};

Error broken(const std::string& name, std::string what) {
  return {.what = std::move(what), .where = name, .fix = "give a PLY file of triangles, ascii or binary_little_endian"};
}

Result<Header> parse_header(std::string_view text, const std::string& name) {
  Header header;
  const std::size_t end = text.substr(0, 1U << 16U).find("end_header");
  if (!text.starts_with("ply") || end == std::string_view::npos) return broken(name, "is not a PLY file");
  const std::size_t newline = text.find('\n', end);
  if (newline == std::string_view::npos) return broken(name, "ends inside its header");
  header.bytes = newline + 1;
  std::istringstream lines{std::string(text.substr(0, end))};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line};
    std::string word;
    words >> word;
    if (word == "format") {
      words >> word;
      header.ascii = word == "ascii";
      if (!header.ascii && word != "binary_little_endian") return broken(name, "has format " + word);
    } else if (word == "element") {
      Element element;
      if (!(words >> element.name >> element.count)) return broken(name, "has a bad line: " + line);
      header.elements.push_back(element);
    } else if (word == "property") {
      Property property;
      std::string type;
      words >> type;
      if (type == "list") {
        words >> type;
        property.count = scalar_named(type);
        if (!property.count) return broken(name, "has a bad line: " + line);
        words >> type;
      }
      const std::optional<Scalar> scalar = scalar_named(type);
      if (!scalar || !(words >> property.name) || header.elements.empty())
        return broken(name, "has a bad line: " + line);
      property.scalar = *scalar;
      header.elements.back().properties.push_back(property);
    }
  }
  return header;
}

/// Reads scalars one after another; what lies past the end makes it fail for good.
class Reader {
 public:
  Reader(std::span<const std::byte> bytes, bool ascii)
      : at_(reinterpret_cast<const char*>(bytes.data())), end_(at_ + bytes.size()), ascii_(ascii) {}

  [[nodiscard]] bool failed() const noexcept { return failed_; }
  [[nodiscard]] std::uint64_t remaining() const noexcept { return static_cast<std::uint64_t>(end_ - at_); }
  double next(Scalar scalar) { return ascii_ ? next_word() : next_binary(scalar); }

 private:
  double next_word() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
    double value = 0.0;
    const auto [rest, code] = std::from_chars(at_, end_, value);
    failed_ = failed_ || code != std::errc{};
    at_ = rest;
    return value;
  }
  template <class T>
  double take() {
    T value{};
    std::memcpy(&value, at_, sizeof value);
    return static_cast<double>(value);
  }
  double next_binary(Scalar scalar) {
    const std::size_t size = bytes_of(scalar);
    failed_ = failed_ || remaining() < size;
    if (failed_) return 0.0;
    const double value = decode(scalar);
    at_ += size;
    return value;
  }
  double decode(Scalar scalar) {
    switch (scalar) {
      case Scalar::I8:
        return take<std::int8_t>();
      case Scalar::U8:
        return take<std::uint8_t>();
      case Scalar::I16:
        return take<std::int16_t>();
      case Scalar::U16:
        return take<std::uint16_t>();
      case Scalar::I32:
        return take<std::int32_t>();
      case Scalar::U32:
        return take<std::uint32_t>();
      case Scalar::F32:
        return take<float>();
      case Scalar::F64:
        return take<double>();
    }
    return 0.0;
  }

  const char* at_;
  const char* end_;
  bool ascii_;
  bool failed_ = false;
};

/// Every element takes at least one byte for each property, in both formats: a cheap bound on a claimed count.
bool fits(const Element& element, const Reader& reader) {
  return element.count <= reader.remaining() && element.count * element.properties.size() <= reader.remaining();
}

void read_vertex(const Element& element, Reader& reader, Eigen::Vector3f& vertex) {
  for (const Property& property : element.properties) {
    if (property.count) {
      const auto corners = static_cast<std::uint64_t>(reader.next(*property.count));
      for (std::uint64_t i = 0; i < corners && !reader.failed(); ++i) (void)reader.next(property.scalar);
      continue;
    }
    const auto value = static_cast<float>(reader.next(property.scalar));
    if (property.name == "x") vertex.x() = value;
    if (property.name == "y") vertex.y() = value;
    if (property.name == "z") vertex.z() = value;
  }
}

/// Adds the polygon's fan; false when a corner names no vertex.
bool read_face(const Element& element, Reader& reader, TriangleMesh& mesh) {
  for (const Property& property : element.properties) {
    const double count = property.count ? reader.next(*property.count) : 1.0;
    if (count < 0.0 || count > static_cast<double>(kMaxPolygonCorners)) return false;
    const bool corners = property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
    std::array<std::uint32_t, 3> fan{};
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double value = reader.next(property.scalar);
      if (!corners) continue;
      if (!(value >= 0.0 && value < static_cast<double>(mesh.vertices.size()))) return false;
      fan[static_cast<std::size_t>(std::min(i, 2))] = static_cast<std::uint32_t>(value);
      if (i < 2) continue;
      mesh.triangles.push_back(fan);
      fan[1] = fan[2];
    }
  }
  return true;
}

}  // namespace

Result<TriangleMesh> parse_ply(std::span<const std::byte> bytes, const std::string& name) {
  const Result<Header> header = parse_header({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name);
  if (!header) return header.error();
  TriangleMesh mesh;
  Reader reader{bytes.subspan(header->bytes), header->ascii};
  for (const Element& element : header->elements) {
    if (!fits(element, reader)) return broken(name, "is shorter than its " + element.name + " count says");
    if (element.name == "vertex") mesh.vertices.reserve(element.count);
    if (element.name == "face") mesh.triangles.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count && !reader.failed(); ++i) {
      if (element.name == "face") {
        if (!read_face(element, reader, mesh)) return broken(name, "has a bad corner in face " + std::to_string(i));
        continue;
      }
      Eigen::Vector3f vertex = Eigen::Vector3f::Zero();
      read_vertex(element, reader, vertex);
      if (element.name != "vertex") continue;
      if (!vertex.allFinite()) return broken(name, "has a vertex that is not finite, number " + std::to_string(i));
      mesh.vertices.push_back(vertex);
    }
    if (reader.failed()) return broken(name, "ends before its last " + element.name);
  }
  if (mesh.triangles.empty()) return broken(name, "has no triangles");
  return mesh;
}

Result<TriangleMesh> read_ply(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMaxPlyBytes) return broken(file.string(), "is larger than 256 MiB");
  std::vector<char> bytes(size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_ply(std::as_bytes(std::span{bytes}), file.string());
}

}  // namespace telepalp::server
