#pragma once

#include "tests/bench/depth_peers.h"

namespace telepalp::bench {

/// FFV1 (RFC 9043) by libavcodec over the ranks of a frame's levels, the levels sent beside it: the strongest of the
/// ready-made codecs on a Kinect's depth. Only where the build found libavcodec.
[[nodiscard]] DepthPeer ffv1_peer();

}  // namespace telepalp::bench
