#pragma once

#include <google/protobuf/timestamp.pb.h>

#include "proto/words/time.h"

namespace telepalp::views {

/// Name of the depth camera's frame of reference in /camera/info and /camera/depth.
inline constexpr const char* kDepthFrame = "camera_depth";

inline void stamp(google::protobuf::Timestamp& timestamp, SessionTime at) {
  constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
  const std::int64_t nanoseconds = to_nanoseconds(at);
  timestamp.set_seconds(nanoseconds / kNanosecondsPerSecond);
  timestamp.set_nanos(static_cast<std::int32_t>(nanoseconds % kNanosecondsPerSecond));
}

}  // namespace telepalp::views
