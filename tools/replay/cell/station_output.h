#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::replay {

/// Called with each message of a station, in order of publication; empty: no messages are made.
using Publish = std::function<void(wire::Message)>;

/// The five instants of one depth frame on its way to the hand [ns of session time]. At `touchable_ns`, the haptic loop
/// can use the surface that was built from the frame.
struct FrameTimes {
  std::uint32_t number = 0;
  std::int64_t captured_ns = 0;
  std::int64_t encoded_ns = 0;
  std::int64_t received_ns = 0;
  std::int64_t decoded_ns = 0;
  std::int64_t touchable_ns = 0;
};

}  // namespace telepalp::replay
