#pragma once

#include <vector>

#include "codec/depth.h"
#include "proto/wire/message.h"

namespace telepalp::report {

/// A session of `seconds` with the messages of a server and a station: a cushion under the camera, 30 frames a second,
/// a hand that presses into it and leaves again every two seconds, a cylinder found on the second touch.
struct MadeSession {
  double seconds = 4.0;
  bool with_station = true;
  bool with_camera = true;
  codec::DepthMode depth_mode = codec::DepthMode::Fast;
  int key_every = 12;  ///< for modes with predicted frames
};
[[nodiscard]] std::vector<wire::Message> made_messages(const MadeSession& made);

inline constexpr std::int64_t kMadeStart_ns = 1'800'000'000'000'000'000;

}  // namespace telepalp::report
