#pragma once

#include <string>

#include "proto/words/result.h"
#include "support/images/image_file.h"

namespace telepalp::server {

/// A binary PGM of 16 bits a sample. Sizes are checked against kMaxImageSide before anything is allocated.
[[nodiscard]] Result<images::GrayImage16> decode_pgm(std::string_view bytes, const std::string& name);
[[nodiscard]] std::string encode_pgm(const images::GrayImage16& image);

}  // namespace telepalp::server
