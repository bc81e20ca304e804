#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// Something else that compresses 16-bit images without loss.
struct DepthPeer {
  std::string name;
  std::function<std::string(const DepthImage& depth)> encode;
  std::function<bool(const std::string& packet, DepthImage& depth)> decode;  ///< `depth` has the size already
};

/// zstd and PNG, and those of CharLS, FFV1 and JPEG XL that the build found.
[[nodiscard]] std::vector<DepthPeer> depth_peers();

/// What the build did not find, for the report's foot.
[[nodiscard]] std::string missing_depth_peers();

}  // namespace telepalp::bench
