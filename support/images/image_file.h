#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::images {

/// One channel of 16-bit samples, rows top to bottom: a depth image without its unit.
struct GrayImage16 {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> samples;
};

/// What an image file holds: depth samples, or a picture. 16-bit gray is the former; 8-bit gray, palette and colour,
/// with or without alpha, are the latter (alpha is dropped).
using AnyImage = std::variant<GrayImage16, ColorImage>;

/// The image in `bytes`. `name` stands for the file in errors. Sizes are checked against kMaxImageSide before anything
/// is allocated; a truncated or damaged image is an error, never half an image.
[[nodiscard]] Result<AnyImage> decode_png(std::span<const std::byte> bytes, const std::string& name);
[[nodiscard]] Result<AnyImage> decode_tiff(std::span<const std::byte> bytes, const std::string& name);

/// PNG or TIFF, told by its first bytes, from a file of at most 256 MiB.
[[nodiscard]] Result<AnyImage> read_image(const std::filesystem::path& file);

/// The same, when the file must hold depth samples or must hold a picture.
[[nodiscard]] Result<GrayImage16> read_depth_image(const std::filesystem::path& file);
[[nodiscard]] Result<ColorImage> read_color_image(const std::filesystem::path& file);

/// PNG bytes of a well-formed, not empty image. Depth samples are kept exactly, as 16-bit gray.
[[nodiscard]] std::string encode_png(const GrayImage16& image);
[[nodiscard]] std::string encode_png(const ColorImage& image);

}  // namespace telepalp::images
