#pragma once

#include <google/protobuf/timestamp.pb.h>

#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::wire {

/// Names of the frames of reference in messages. Depth, and colour that is registered to depth, are in kDepthFrameId;
/// other colour is in kColorFrameId.
inline constexpr const char* kDepthFrameId = "camera_depth";
inline constexpr const char* kColorFrameId = "camera_color";

inline constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

/// Sets a message's timestamp to session time.
inline void set_stamp(google::protobuf::Timestamp& timestamp, SessionTime at) {
  timestamp.set_seconds(to_nanoseconds(at) / kNanosecondsPerSecond);
  timestamp.set_nanos(static_cast<std::int32_t>(to_nanoseconds(at) % kNanosecondsPerSecond));
}

/// Session time [ns] of a message's timestamp. A time that exceeds 64 bits, as from a hostile peer, wraps around.
[[nodiscard]] inline std::int64_t stamp_ns(const google::protobuf::Timestamp& timestamp) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(timestamp.seconds()) * kNanosecondsPerSecond +
                                   static_cast<std::uint64_t>(timestamp.nanos()));
}

}  // namespace telepalp::wire
