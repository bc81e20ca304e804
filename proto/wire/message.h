#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "proto/wire/topics.h"
#include "proto/words/demand.h"
#include "proto/words/time.h"

namespace telepalp::wire {

/// Largest payload of a message; a frame that declares more is refused before memory is allocated.
inline constexpr std::size_t kMaxPayloadBytes = std::size_t{8} << 20;

/// Whether a message is a key frame: true if it is decoded without the topic's message before it. There is no default
/// value, so that whoever makes a message says it.
class KeyFrame {
 public:
  constexpr KeyFrame(std::same_as<bool> auto is_key) noexcept : is_key_(is_key) {}
  constexpr operator bool() const noexcept { return is_key_; }

 private:
  bool is_key_;
};

/// One time-stamped message on a topic. The payload is a serialised Protobuf message of the topic's type. It is a
/// shared_ptr because it is encoded once and sent to all subscribers.
struct Message {
  Topic topic;
  SessionTime published;
  std::shared_ptr<const std::string> payload;
  std::uint64_t sequence = 0;  ///< number within the topic, from 1, given by the sender; a gap means lost messages.
                               ///< 0: not numbered yet
  KeyFrame key_frame;          ///< always true unless the topic is Topic::predicted
};

/// Serialises `proto` as a message of `topic`. The topic of a predicted message (`key_frame` false) is one that may be.
template <class Proto>
[[nodiscard]] Message make_message(const Topic& topic, SessionTime published, const Proto& proto, KeyFrame key_frame) {
  demand(topic.predicted || key_frame, "only a topic with predicted messages has one that is no key frame");
  return {topic, published, std::make_shared<const std::string>(proto.SerializeAsString()), 0, key_frame};
}

/// Serialises `proto` as a message of `topic`, which is one without predicted messages.
template <class Proto>
[[nodiscard]] Message make_message(const Topic& topic, SessionTime published, const Proto& proto) {
  demand(!topic.predicted, "a message that may be predicted is made with its key_frame");
  return make_message(topic, published, proto, true);
}

}  // namespace telepalp::wire
