#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "proto/wire/topics.h"
#include "proto/words/time.h"

namespace telepalp::wire {

/// Largest payload of a message; a frame that declares more is refused before memory is allocated.
inline constexpr std::size_t kMaxPayloadBytes = std::size_t{8} << 20;

/// One time-stamped message on a topic. The payload is a serialised Protobuf message of the topic's type. It is a
/// shared_ptr because it is encoded once and sent to all subscribers.
struct Message {
  Topic topic;
  SessionTime published;
  std::shared_ptr<const std::string> payload;
  std::uint64_t sequence = 0;  ///< number within the topic, from 1, given by the sender; a gap means lost messages.
                               ///< 0: not numbered yet
  bool key_frame = true;       ///< false: decoding needs the topic's message before this one. Set by the publisher;
                               ///< not sent on the wire
};

/// Serialises `proto` as a message of `topic`.
template <class Proto>
[[nodiscard]] Message make_message(const Topic& topic, SessionTime published, const Proto& proto) {
  return {topic, published, std::make_shared<const std::string>(proto.SerializeAsString())};
}

}  // namespace telepalp::wire
