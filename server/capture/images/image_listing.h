#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::capture {

/// The depth and colour file of one frame, relative to the directory.
struct ImagePair {
  std::filesystem::path depth;
  std::optional<std::filesystem::path> color;
};

/// Orders the images of a directory into a sequence. Three layouts are recognised:
///   depth/ and rgb/ (or color/, colour/), whose file names agree but for these words, or in their last number,
///   depth and colour side by side, distinguished by a word in the name: frame_7_depth.tiff, frame_7_rgb.tiff, and
///   depth alone: 30.png, 50.png, ….
/// A JPEG is a colour image. `files` are relative paths; files other than PNG, TIFF and JPEG are ignored. Names are
/// ordered by their last number, which must increase in equal steps, with leading zeros in all names or in none; names
/// with a time of day (…T142255.814212) are ordered as text. `where`: the directory, for errors. Error: no depth image,
/// a missing or repeated number, a number with fewer digits, or a depth image without its colour.
[[nodiscard]] Result<std::vector<ImagePair>> order_images(const std::vector<std::filesystem::path>& files,
                                                          const std::string& where);

}  // namespace telepalp::capture
