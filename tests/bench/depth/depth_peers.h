#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// Another lossless codec for 16-bit images.
struct DepthPeer {
  std::string name;
  std::function<std::string(const DepthImage& depth)> encode;
  std::function<bool(const std::string& packet, DepthImage& depth)> decode;  ///< `depth` has the size already
};

/// zstd, PNG, and CharLS, FFV1 and JPEG XL if the build found them.
[[nodiscard]] std::vector<DepthPeer> depth_peers();

/// Names of the codecs that the build did not find, for the foot of the report.
[[nodiscard]] std::string missing_depth_peers();

}  // namespace telepalp::bench
