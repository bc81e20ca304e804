#include <bit>
#include <cstring>
#include <limits>

#include "support/models/lzf.h"
#include "support/models/point_model.h"
#include "support/models/text_cursor.h"

namespace telepalp::models {
namespace {

struct Field {
  std::string name;
  std::size_t bytes = 4;
  char type = 'F';
  std::size_t count = 1;
};

struct Header {
  std::vector<Field> fields;
  std::size_t width = 0;
  std::size_t height = 1;
  std::size_t points = 0;
  std::string data;
  std::size_t data_at = 0;
  std::size_t first_data_line = 0;
};

Error bad(const std::string& name, const std::string& what) {
  return {.what = what, .where = name, .fix = "write the cloud again, as PCD v0.7"};
}

/// Field indices of x, y, z, the normal and the colour in a point.
struct FieldIndices {
  std::array<std::size_t, 3> at{};
  std::array<std::size_t, 3> normal{};
  std::size_t color = 0;
  bool has_normal = false;
  bool has_color = false;
};

template <class Set>
bool fill(std::vector<Field>& fields, std::string_view rest, Set set) {
  for (Field& field : fields) {
    const std::string_view word = TextCursor::word_of(rest);
    if (word.empty() || !set(field, word)) return false;
  }
  return TextCursor::word_of(rest).empty();
}

bool set_size(std::size_t& to, std::string_view word, std::size_t least, std::size_t most) {
  const auto value = TextCursor::number<std::size_t>(word);
  if (!value || *value < least || *value > most) return false;
  to = *value;
  return true;
}

Result<Header> parse_header(std::span<const std::byte> bytes, const std::string& name) {
  TextCursor text(bytes);
  Header header;
  bool sized = false;
  while (!text.at_end()) {
    std::string_view rest = text.line();
    const std::string_view key = TextCursor::word_of(rest);
    bool understood = true;
    if (key == "FIELDS" || key == "COLUMNS") {
      for (std::string_view word = TextCursor::word_of(rest); !word.empty(); word = TextCursor::word_of(rest))
        header.fields.push_back({.name = std::string(word)});
      understood = !header.fields.empty() && header.fields.size() <= 64;
    } else if (key == "SIZE") {
      understood = fill(header.fields, rest, [](Field& f, std::string_view w) { return set_size(f.bytes, w, 1, 8); });
    } else if (key == "TYPE") {
      understood = fill(header.fields, rest, [](Field& f, std::string_view w) {
        f.type = w[0];
        return w == "F" || w == "I" || w == "U";
      });
    } else if (key == "COUNT") {
      understood =
          fill(header.fields, rest, [](Field& f, std::string_view w) { return set_size(f.count, w, 1, 4096); });
    } else if (key == "WIDTH") {
      understood = set_size(header.width, TextCursor::word_of(rest), 0, kMostModelPoints);
    } else if (key == "HEIGHT") {
      understood = set_size(header.height, TextCursor::word_of(rest), 1, kMostModelPoints);
    } else if (key == "POINTS") {
      sized = understood = set_size(header.points, TextCursor::word_of(rest), 0, kMostModelPoints);
    } else if (key == "DATA") {
      header.data = TextCursor::word_of(rest);
      header.data_at = text.offset();
      header.first_data_line = text.line_number();
      if (!sized) header.points = header.width * header.height;
      if (header.fields.empty() || header.points > kMostModelPoints ||
          (header.width > 0 && header.width * header.height != header.points))
        return bad(
            name,
            "the header's WIDTH, HEIGHT and POINTS disagree or give more than 20 million points, or FIELDS is missing");
      return header;
    }
    if (!understood)
      return bad(name, "line " + std::to_string(text.line_number()) + " of the header has a value of " +
                           std::string(key) +
                           " that is not allowed; the limits are 20 million points, 64 fields and 4096 values a field");
  }
  return bad(name, "is not a PCD file: there is no DATA line");
}

Result<FieldIndices> fields_of(const Header& header, const std::string& name) {
  FieldIndices fields;
  const auto find = [&](const char* wanted, std::size_t& to) {
    for (std::size_t i = 0; i < header.fields.size(); ++i)
      if (header.fields[i].name == wanted && header.fields[i].type == 'F' && header.fields[i].count == 1 &&
          (header.fields[i].bytes == 4 || header.fields[i].bytes == 8)) {
        to = i;
        return true;
      }
    return false;
  };
  if (!find("x", fields.at[0]) || !find("y", fields.at[1]) || !find("z", fields.at[2]))
    return bad(name, "does not have all three fields x, y and z with TYPE F (floating-point numbers)");
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const Field& field = header.fields[i];
    if ((field.name != "rgb" && field.name != "rgba") || field.bytes != 4 || field.count != 1) continue;
    fields.color = i;
    fields.has_color = true;
  }
  fields.has_normal =
      find("normal_x", fields.normal[0]) && find("normal_y", fields.normal[1]) && find("normal_z", fields.normal[2]);
  return fields;
}

PointModel sized_model(const Header& header, const FieldIndices& fields) {
  PointModel model;
  model.points.resize(header.points);
  if (fields.has_normal) model.normals.resize(header.points);
  if (fields.has_color) model.colors.resize(header.points);
  if (header.height > 1) model.width = static_cast<int>(header.width);
  return model;
}

/// PCL packs colour as 0xAARRGGBB, in an integer or in a float's bits.
std::array<std::uint8_t, 3> unpacked(std::uint32_t argb) {
  return {static_cast<std::uint8_t>(argb >> 16U), static_cast<std::uint8_t>(argb >> 8U),
          static_cast<std::uint8_t>(argb)};
}

std::uint32_t packed(double value, char type) {
  if (type != 'F') return value >= 0.0 && value < 4294967296.0 ? static_cast<std::uint32_t>(value) : 0U;
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

Result<PointModel> parse_ascii(std::span<const std::byte> bytes, const Header& header, const FieldIndices& fields,
                               const std::string& name) {
  if (bytes.size() / 2 < header.points)
    return bad(name, "is too short for the " + std::to_string(header.points) + " points that its header declares");
  PointModel model = sized_model(header, fields);
  TextCursor text(bytes);
  std::vector<double> values(header.fields.size());
  for (std::size_t point = 0; point < header.points; ++point) {
    for (std::size_t field = 0; field < header.fields.size(); ++field)
      for (std::size_t k = 0; k < header.fields[field].count; ++k) {
        const std::string_view word = text.word();
        const auto value = TextCursor::number<double>(word);
        if (word.empty() || (!value && word != "nan" && word != "-nan"))
          return bad(name, "point " + std::to_string(point) + ", counted from 0, is missing or not a number");
        values[field] = value.value_or(std::numeric_limits<double>::quiet_NaN());
      }
    const auto number = [&](std::size_t field) { return static_cast<float>(values[field]); };
    const auto three = [&](const std::array<std::size_t, 3>& at) -> Eigen::Vector3f {
      return {number(at[0]), number(at[1]), number(at[2])};
    };
    model.points[point] = three(fields.at);
    if (fields.has_normal) model.normals[point] = three(fields.normal);
    if (fields.has_color)
      model.colors[point] = unpacked(packed(values[fields.color], header.fields[fields.color].type));
  }
  return model;
}

float value_at(const std::byte* at, std::size_t bytes) {
  if (bytes == 4) {
    float value = 0.0F;
    std::memcpy(&value, at, sizeof value);
    return value;
  }
  double value = 0.0;
  std::memcpy(&value, at, sizeof value);
  return static_cast<float>(value);
}

/// `by_field`: all values of one field, then all of the next (compressed files); otherwise point by point.
Result<PointModel> parse_binary(std::span<const std::byte> bytes, const Header& header, const FieldIndices& fields,
                                bool by_field, const std::string& name) {
  std::size_t point_bytes = 0;
  std::vector<std::size_t> offsets;
  for (const Field& field : header.fields) {
    offsets.push_back(point_bytes);
    point_bytes += field.bytes * field.count;
  }
  if (bytes.size() / point_bytes < header.points)
    return bad(name, "ends after " + std::to_string(bytes.size() / point_bytes) + " of " +
                         std::to_string(header.points) + " points");
  PointModel model = sized_model(header, fields);
  const auto at = [&](std::size_t point, std::size_t field) {
    const Field& of = header.fields[field];
    return &bytes[by_field ? offsets[field] * header.points + point * of.bytes * of.count
                           : point * point_bytes + offsets[field]];
  };
  const auto read = [&](std::size_t point, std::size_t field) {
    return value_at(at(point, field), header.fields[field].bytes);
  };
  for (std::size_t point = 0; point < header.points; ++point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<Eigen::Index>(axis);
      model.points[point][row] = read(point, fields.at[axis]);
      if (fields.has_normal) model.normals[point][row] = read(point, fields.normal[axis]);
    }
    if (!fields.has_color) continue;
    std::uint32_t argb = 0;
    std::memcpy(&argb, at(point, fields.color), sizeof argb);
    model.colors[point] = unpacked(argb);
  }
  return model;
}

Result<PointModel> parse_compressed(std::span<const std::byte> bytes, const Header& header, const FieldIndices& fields,
                                    const std::string& name) {
  std::uint32_t sizes[2] = {};
  if (bytes.size() < sizeof sizes) return bad(name, "is cut off before its compressed data begin");
  std::memcpy(sizes, bytes.data(), sizeof sizes);
  std::size_t point_bytes = 0;
  for (const Field& field : header.fields) point_bytes += field.bytes * field.count;
  if (sizes[0] > bytes.size() - sizeof sizes || sizes[1] != point_bytes * header.points)
    return bad(name, "has compressed sizes that disagree with the size of the file or with its header");
  if (sizes[1] > lzf_most(sizes[0]))
    return bad(name, "declares more decompressed bytes than its compressed data can give");
  std::vector<std::byte> plain(sizes[1]);
  if (!lzf_decompress(bytes.subspan(sizeof sizes, sizes[0]), plain)) return bad(name, "has damaged compressed data");
  return parse_binary(plain, header, fields, true, name);
}

}  // namespace

Result<PointModel> parse_pcd(std::span<const std::byte> bytes, const std::string& name) {
  const Result<Header> header = parse_header(bytes, name);
  if (!header) return header.error();
  const Result<FieldIndices> fields = fields_of(*header, name);
  if (!fields) return fields.error();
  const std::span<const std::byte> data = bytes.subspan(header->data_at);
  if (header->data == "ascii") return parse_ascii(data, *header, *fields, name);
  if (header->data == "binary") return parse_binary(data, *header, *fields, false, name);
  if (header->data == "binary_compressed") return parse_compressed(data, *header, *fields, name);
  return bad(name, "has DATA '" + header->data + "', which is not ascii, binary or binary_compressed");
}

}  // namespace telepalp::models
