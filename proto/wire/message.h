#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "proto/wire/topics.h"
#include "proto/words/time.h"

namespace telepalp::wire {

/// The most that one message may weigh on any channel; a frame that declares more is refused before allocation.
inline constexpr std::size_t kMaxPayloadBytes = std::size_t{8} << 20;

/// One timestamped message on a topic. The payload is a serialised Protobuf message of the topic's schema; it is
/// shared because it is encoded once and handed, unchanged, to every subscriber and the recorder.
struct Message {
  Topic topic;
  SessionTime published;
  std::shared_ptr<const std::string> payload;
  std::uint64_t sequence = 0;  ///< counts the topic's messages at whoever sends them on, from 1; a gap is a loss.
                               ///< 0: not numbered yet
  bool stands_alone = true;    ///< false: of use only to who has the topic's message before it. Its publisher's word;
                               ///< not on the wire
};

/// Serialises `proto` as a message of `topic`.
template <class Proto>
[[nodiscard]] Message make_message(const Topic& topic, SessionTime published, const Proto& proto) {
  return {topic, published, std::make_shared<const std::string>(proto.SerializeAsString())};
}

}  // namespace telepalp::wire
