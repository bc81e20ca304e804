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

/// The content of an image file. A 16-bit grey file becomes depth samples. An 8-bit grey, palette or colour file
/// becomes a colour image; its alpha channel is dropped.
using AnyImage = std::variant<GrayImage16, ColorImage>;

/// Decodes `bytes`. `name`: the file's name, for errors. The size is checked against kMaxImageSide before memory is
/// allocated. Error: a truncated or damaged image.
[[nodiscard]] Result<AnyImage> decode_png(std::span<const std::byte> bytes, const std::string& name);
[[nodiscard]] Result<AnyImage> decode_tiff(std::span<const std::byte> bytes, const std::string& name);

/// Reads a PNG or TIFF file, recognised by its first bytes. Error: over 256 MiB, unreadable, damaged or another format.
[[nodiscard]] Result<AnyImage> read_image(const std::filesystem::path& file);

/// read_image() for a file that must contain depth, or colour. Error: it contains the other kind of image.
[[nodiscard]] Result<GrayImage16> read_depth_image(const std::filesystem::path& file);
[[nodiscard]] Result<ColorImage> read_color_image(const std::filesystem::path& file);

/// Encodes a well-formed, non-empty image as PNG. Depth samples are stored losslessly as 16-bit grey.
[[nodiscard]] std::string encode_png(const GrayImage16& image);
[[nodiscard]] std::string encode_png(const ColorImage& image);

}  // namespace telepalp::images
