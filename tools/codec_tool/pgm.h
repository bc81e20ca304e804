#pragma once

#include <string>

#include "proto/words/result.h"
#include "support/images/image_file.h"

namespace telepalp::codec_tool {

/// Decodes a binary PGM with 16 bits per sample. The size is checked against kMaxImageSide before memory is allocated.
/// `name`: the file's name, for errors.
[[nodiscard]] Result<images::GrayImage16> decode_pgm(std::string_view bytes, const std::string& name);
[[nodiscard]] std::string encode_pgm(const images::GrayImage16& image);

}  // namespace telepalp::codec_tool
