#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// How depth is compressed; the name is what the command line and DepthImage.format say.
enum class DepthMode { Fast };

[[nodiscard]] std::string_view name(DepthMode mode) noexcept;

/// Compresses one depth image without loss. `depth` must be well formed.
[[nodiscard]] std::string encode_depth(const DepthImage& depth, DepthMode mode = DepthMode::Fast);

/// The image that `packet` holds, of any mode. A damaged or hostile packet is an error; nothing is allocated
/// beyond what kMaxImageSide allows.
[[nodiscard]] Result<DepthImage> decode_depth(std::span<const std::byte> packet);

}  // namespace telepalp::codec
