#include "support/images/image_file.h"

#include <fstream>
#include <string_view>
#include <system_error>

namespace telepalp::images {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 256U << 20U;

Result<std::vector<char>> read_bytes(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMaxFileBytes)
    return Error{.what = "is larger than 256 MiB", .where = file.string(), .fix = "give a smaller PNG or TIFF image"};
  std::vector<char> bytes(size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return bytes;
}

}  // namespace

Result<AnyImage> read_image(const std::filesystem::path& file) {
  const Result<std::vector<char>> read = read_bytes(file);
  if (!read) return read.error();
  const std::string_view start{read->data(), std::min<std::size_t>(read->size(), 4)};
  const auto bytes = std::as_bytes(std::span{*read});
  if (start.starts_with("\x89PNG")) return decode_png(bytes, file.string());
  if (start.starts_with("II") || start.starts_with("MM")) return decode_tiff(bytes, file.string());
  return Error{.what = "is neither a PNG nor a TIFF image", .where = file.string(), .fix = "give a PNG or TIFF image"};
}

Result<GrayImage16> read_depth_image(const std::filesystem::path& file) {
  Result<AnyImage> image = read_image(file);
  if (!image) return image.error();
  if (auto* depth = std::get_if<GrayImage16>(&*image)) return std::move(*depth);
  return Error{.what = "is not a 16-bit grey image, as depth must be",
               .where = file.string(),
               .fix = "save depth as 16-bit grey PNG or TIFF"};
}

Result<ColorImage> read_color_image(const std::filesystem::path& file) {
  Result<AnyImage> image = read_image(file);
  if (!image) return image.error();
  if (auto* color = std::get_if<ColorImage>(&*image)) return std::move(*color);
  return Error{.what = "is a 16-bit grey image, not an 8-bit colour image",
               .where = file.string(),
               .fix = "give an 8-bit RGB PNG or TIFF"};
}

}  // namespace telepalp::images
