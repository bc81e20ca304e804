#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::replay {

/// Gets the messages of a station in the order of its publishing; empty: nobody listens, and none are made.
using Publish = std::function<void(wire::Message)>;

/// The times of one depth frame on its way to the hand [ns of session time]; 0: not reached.
struct FrameTimes {
  std::uint32_t number = 0;
  std::int64_t captured_ns = 0;
  std::int64_t encoded_ns = 0;
  std::int64_t received_ns = 0;
  std::int64_t decoded_ns = 0;
  std::int64_t touchable_ns = 0;
};

}  // namespace telepalp::replay
