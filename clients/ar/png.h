#pragma once

#include <string>

#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// The bytes of a PNG file of `image`, which must be well formed and not empty.
[[nodiscard]] std::string encode_png(const ColorImage& image);

}  // namespace telepalp::ar
