#pragma once

#include "tests/bench/depth/depth_peers.h"

namespace telepalp::bench {

/// FFV1 (RFC 9043) by libavcodec, applied to the ranks of a frame's levels; the levels are stored separately. It is the
/// strongest existing codec for Kinect depth. Available only if the build found libavcodec.
[[nodiscard]] DepthPeer ffv1_peer();

}  // namespace telepalp::bench
