#include "server/capture/pcd/pcd.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

#include "server/capture/pcd/lzf.h"

namespace telepalp::server {
namespace {

constexpr std::uintmax_t kMaxPcdBytes = 512U << 20U;
constexpr std::size_t kMaxFields = 64;
constexpr std::size_t kMaxPointBytes = 1024;

struct Field {
  std::string name;
  std::size_t size = 4;
  char type = 'F';
  std::size_t count = 1;
  std::size_t offset = 0;  // bytes from the point's start
};
struct Header {
  std::vector<Field> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::string data;
  std::size_t bytes = 0;
  std::size_t point_bytes = 0;

  [[nodiscard]] std::size_t points() const { return static_cast<std::size_t>(width * height); }
  [[nodiscard]] const Field* field(std::string_view name) const {
    for (const Field& one : fields)
      if (one.name == name) return &one;
    return nullptr;
  }
};

Error broken(const std::string& name, std::string what) {
  return {.what = std::move(what),
          .where = name,
          .fix = "give an organised PCD (one point a pixel) with fields x y z, as PCL saves a camera's cloud"};
}

/// Reads one word into each field by `set`; false when there are fewer words than fields, or a bad one.
template <class Set>
bool each_field(std::istringstream& words, std::vector<Field>& fields, Set set) {
  std::string word;
  for (Field& field : fields)
    if (!(words >> word) || !set(field, word)) return false;
  return true;
}

bool whole(const std::string& word, std::size_t most, std::size_t& value) {
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  return code == std::errc{} && end == word.data() + word.size() && value >= 1 && value <= most;
}

bool read_line(const std::string& line, Header& header) {
  std::istringstream words{line};
  std::string key;
  words >> key;
  if (key == "FIELDS") {
    for (std::string name; header.fields.size() < kMaxFields && words >> name;)
      header.fields.push_back({.name = name, .size = 4, .type = 'F', .count = 1, .offset = 0});
    return !header.fields.empty();
  }
  if (key == "SIZE")
    return each_field(words, header.fields, [](Field& f, const std::string& w) { return whole(w, 8, f.size); });
  if (key == "COUNT")
    return each_field(words, header.fields,
                      [](Field& f, const std::string& w) { return whole(w, kMaxPointBytes, f.count); });
  if (key == "TYPE")
    return each_field(words, header.fields, [](Field& f, const std::string& w) {
      f.type = w.front();
      return w == "F" || w == "U" || w == "I";
    });
  if (key == "WIDTH") return static_cast<bool>(words >> header.width);
  if (key == "HEIGHT") return static_cast<bool>(words >> header.height);
  if (key == "DATA") return static_cast<bool>(words >> header.data);
  return true;  // VERSION, VIEWPOINT, POINTS, comments
}

Result<Header> parse_header(std::string_view text, const std::string& name) {
  Header header;
  if (text.substr(0, 256).find("VERSION") == std::string_view::npos) return broken(name, "is not a PCD file");
  while (header.data.empty()) {
    const std::size_t newline = text.substr(header.bytes, 4096).find('\n');
    if (newline == std::string_view::npos) return broken(name, "ends inside its header");
    const std::string line{text.substr(header.bytes, newline)};
    header.bytes += newline + 1;
    if (!read_line(line, header)) return broken(name, "has a bad line: " + line);
  }
  for (Field& field : header.fields) {
    field.offset = header.point_bytes;
    header.point_bytes += field.size * field.count;
  }
  if (header.point_bytes > kMaxPointBytes) return broken(name, "has points of more than 1 KiB");
  for (const char* axis : {"x", "y", "z"})
    if (const Field* field = header.field(axis); field == nullptr || field->type != 'F' || field->size != 4)
      return broken(name, "has no field " + std::string(axis) + " of type F 4");
  if (header.height <= 1)
    return broken(name, "is not organised: " + std::to_string(header.width) + " points in one row");
  if (header.width < 1 || header.width > kMaxImageSide || header.height > kMaxImageSide)
    return broken(name, "is " + std::to_string(header.width) + " x " + std::to_string(header.height) + " points");
  return header;
}

/// Where each point's value of a field lies, in the two binary layouts: point by point, or field by field.
struct Layout {
  const std::byte* data;
  std::size_t point_bytes;
  std::size_t points;
  bool by_field;

  [[nodiscard]] const std::byte* at(const Field& field, std::size_t point) const {
    return by_field ? data + points * field.offset + point * field.size * field.count
                    : data + point * point_bytes + field.offset;
  }
};

OrganisedCloud empty_cloud(const Header& header, bool colored) {
  OrganisedCloud cloud{static_cast<int>(header.width), static_cast<int>(header.height), {}, {}, {}, {}};
  for (std::vector<float>* axis : {&cloud.x, &cloud.y, &cloud.z}) axis->resize(header.points());
  if (colored) cloud.rgb.resize(3 * header.points());
  return cloud;
}

const Field* color_field(const Header& header) {
  const Field* field = header.field("rgb") != nullptr ? header.field("rgb") : header.field("rgba");
  return field != nullptr && field->size == 4 ? field : nullptr;
}

/// PCL packs colour as 0xAARRGGBB, in a float's bits or an integer.
void set_color(OrganisedCloud& cloud, std::size_t point, std::uint32_t argb) {
  cloud.rgb[3 * point] = static_cast<std::uint8_t>(argb >> 16U);
  cloud.rgb[3 * point + 1] = static_cast<std::uint8_t>(argb >> 8U);
  cloud.rgb[3 * point + 2] = static_cast<std::uint8_t>(argb);
}

OrganisedCloud unpack(const Header& header, const Layout& layout) {
  const Field* color = color_field(header);
  OrganisedCloud cloud = empty_cloud(header, color != nullptr);
  const std::array<std::pair<const Field*, float*>, 3> axes{
      {{header.field("x"), cloud.x.data()}, {header.field("y"), cloud.y.data()}, {header.field("z"), cloud.z.data()}}};
  for (std::size_t point = 0; point < header.points(); ++point) {
    for (const auto& [field, values] : axes) std::memcpy(&values[point], layout.at(*field, point), sizeof(float));
    if (color == nullptr) continue;
    std::uint32_t argb = 0;
    std::memcpy(&argb, layout.at(*color, point), sizeof argb);
    set_color(cloud, point, argb);
  }
  return cloud;
}

Result<OrganisedCloud> read_ascii(const Header& header, std::string_view text, const std::string& name) {
  if (text.size() < 2 * header.points()) return broken(name, "is shorter than its size says");
  const Field* color = color_field(header);
  OrganisedCloud cloud = empty_cloud(header, color != nullptr);
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t point = 0; point < header.points(); ++point)
    for (const Field& field : header.fields)
      for (std::size_t i = 0; i < field.count; ++i) {
        while (at != end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t')) ++at;
        double value = 0.0;
        const auto [rest, code] = std::from_chars(at, end, value);
        if (code != std::errc{})
          return broken(name, "has no number for " + field.name + " of point " + std::to_string(point));
        at = rest;
        if (field.name == "x") cloud.x[point] = static_cast<float>(value);
        if (field.name == "y") cloud.y[point] = static_cast<float>(value);
        if (field.name == "z") cloud.z[point] = static_cast<float>(value);
        if (&field != color) continue;
        const auto as_float = static_cast<float>(value);
        std::uint32_t argb = value >= 0.0 && value < 4294967296.0 ? static_cast<std::uint32_t>(value) : 0U;
        if (field.type == 'F') std::memcpy(&argb, &as_float, sizeof argb);
        set_color(cloud, point, argb);
      }
  return cloud;
}

Result<OrganisedCloud> read_compressed(const Header& header, std::span<const std::byte> body, const std::string& name) {
  std::array<std::uint32_t, 2> sizes{};  // compressed, uncompressed
  if (body.size() < sizeof sizes) return broken(name, "ends before its points");
  std::memcpy(sizes.data(), body.data(), sizeof sizes);
  body = body.subspan(sizeof sizes);
  if (sizes[0] > body.size() || sizes[1] != header.points() * header.point_bytes || sizes[1] > lzf_most(sizes[0]))
    return broken(name, "is shorter than its size says");
  std::vector<std::byte> points(sizes[1]);
  if (!lzf_decompress(body.first(sizes[0]), points)) return broken(name, "has damaged points");
  return unpack(header, {points.data(), header.point_bytes, header.points(), true});
}

}  // namespace

Result<OrganisedCloud> parse_pcd(std::span<const std::byte> bytes, const std::string& name) {
  const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  const Result<Header> header = parse_header(text, name);
  if (!header) return header.error();
  const std::span<const std::byte> body = bytes.subspan(header->bytes);
  if (header->data == "ascii") return read_ascii(*header, text.substr(header->bytes), name);
  if (header->data == "binary_compressed") return read_compressed(*header, body, name);
  if (header->data != "binary") return broken(name, "has DATA " + header->data);
  if (body.size() < header->points() * header->point_bytes) return broken(name, "is shorter than its size says");
  return unpack(*header, {body.data(), header->point_bytes, header->points(), false});
}

Result<OrganisedCloud> read_pcd(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMaxPcdBytes) return broken(file.string(), "is larger than 512 MiB");
  std::vector<char> bytes(size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_pcd(std::as_bytes(std::span{bytes}), file.string());
}

}  // namespace telepalp::server
