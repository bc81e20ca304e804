#include <algorithm>
#include <cstring>

#include "support/models/mesh_parts.h"
#include "support/models/point_model.h"
#include "support/models/text_cursor.h"

namespace telepalp::models {
namespace {

struct Property {
  std::string name;
  std::size_t bytes = 4;
  bool real = true;
  std::size_t count_bytes = 0;  ///< size of a list's length; 0: not a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

std::optional<Property> type_of(std::string_view word) {
  if (word == "float" || word == "float32") return Property{.name = {}, .bytes = 4, .real = true};
  if (word == "double" || word == "float64") return Property{.name = {}, .bytes = 8, .real = true};
  const bool one = word == "char" || word == "uchar" || word == "int8" || word == "uint8";
  const bool two = word == "short" || word == "ushort" || word == "int16" || word == "uint16";
  const bool four = word == "int" || word == "uint" || word == "int32" || word == "uint32";
  if (!one && !two && !four) return std::nullopt;
  return Property{.name = {}, .bytes = one ? 1U : (two ? 2U : 4U), .real = false};
}

/// Reads numbers in order, from text or from little-endian bytes. Fails permanently at the end of the data.
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
  if (text.line() != "ply") return bad_mesh(name, "is not a PLY file");
  PlyHeader header;
  while (!text.at_end()) {
    std::string_view rest = text.line();
    const std::string_view key = TextCursor::word_of(rest);
    const std::string_view first = TextCursor::word_of(rest);
    if (key == "format") {
      header.ascii = first == "ascii";
      if (!header.ascii && first != "binary_little_endian")
        return bad_mesh(name, "has the format " + std::string(first) + ", which cannot be read");
    } else if (key == "element") {
      const auto count = TextCursor::number<std::size_t>(TextCursor::word_of(rest));
      if (!count || *count > 3 * kMostModelPoints || *count > bytes.size())
        return bad_mesh(name,
                        "declares a number of elements of the kind '" + std::string(first) +
                            "' that is not a whole number, is above 60 million, or is too large for the file's size");
      const auto same = [&](const Element& element) { return element.name == first; };
      if (std::any_of(header.elements.begin(), header.elements.end(), same))
        return bad_mesh(name, "has two elements called '" + std::string(first) + "'");
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
      if (!property) return bad_mesh(name, "has a property whose type is not a PLY number type such as float or uchar");
      property->name = TextCursor::word_of(rest);
      header.elements.back().properties.push_back(*property);
    } else if (key == "end_header") {
      header.data_at = text.offset();
      return header;
    }
  }
  return bad_mesh(name, "has no line end_header");
}

Result<void> read_vertices(const Element& element, Numbers& numbers, PointModel& model, const std::string& name) {
  const char* wanted[6] = {"x", "y", "z", "nx", "ny", "nz"};
  std::array<float, 6> values{};
  std::array<bool, 6> present{};
  for (const Property& property : element.properties)
    for (std::size_t k = 0; k < 6; ++k) present[k] = present[k] || property.name == wanted[k];
  if (!present[0] || !present[1] || !present[2])
    return bad_mesh(name, "has vertices that do not have all three properties x, y and z");
  const bool with_normals = present[3] && present[4] && present[5];
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (property.count_bytes != 0)
        return bad_mesh(name, "has a list among the properties of its vertices, which is not supported");
      const auto value = static_cast<float>(numbers.next(property.bytes, property.real));
      for (std::size_t k = 0; k < 6; ++k)
        if (property.name == wanted[k]) values[k] = value;
    }
    if (!numbers.ok())
      return bad_mesh(name, "a number of vertex " + std::to_string(i) + " of " + std::to_string(element.count) +
                                ", counted from 0, is missing or is not a number");
    model.points.emplace_back(values[0], values[1], values[2]);
    if (with_normals) model.normals.emplace_back(values[3], values[4], values[5]);
  }
  return {};
}

/// The vertex index in a number. An invalid number becomes an index that no vertex can have.
std::uint32_t to_corner(double value) {
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  return value >= 0.0 && value < kNone ? static_cast<std::uint32_t>(value) : kNone;
}

/// Reads the faces, or skips an element that is not needed.
Result<void> read_lists(const Element& element, Numbers& numbers, PointModel& model, const std::string& name) {
  constexpr double kMostCorners = 1000.0;
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < element.count; ++i)
    for (const Property& property : element.properties) {
      const double length = property.count_bytes == 0 ? 1.0 : numbers.next(property.count_bytes, false);
      if (!numbers.ok() || !(length >= 0.0 && length <= kMostCorners))
        return bad_mesh(name, "the list of " + element.name + " " + std::to_string(i) +
                                  ", counted from 0, is missing, or its length is not 0 to 1000");
      corners.clear();
      for (int k = 0; k < static_cast<int>(length); ++k)
        corners.push_back(to_corner(numbers.next(property.bytes, property.real)));
      if (!numbers.ok())
        return bad_mesh(name, "a number of " + element.name + " " + std::to_string(i) +
                                  ", counted from 0, is missing or is not a number");
      if (element.name == "face" && property.count_bytes != 0 && property.name.starts_with("vertex_ind"))
        add_fan(corners, model);
    }
  return {};
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
  return checked_mesh(std::move(model), name);
}

}  // namespace telepalp::models
