#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/message.h"

namespace telepalp::relay {

// A message goes through the cluster in one or more parts, because a NATS server refuses a payload above its limit, by
// default 1 MiB. Each part begins with 32 bytes, little-endian: "TPR1", the message's number within its topic (8), its
// time of publishing as session time [ns] (8), flags (2; bit 0: key frame), the part's number from 0 (2), the number of
// parts (2), 2 zero bytes, the size of the whole payload (4).
inline constexpr std::size_t kPartHeaderBytes = 32;
inline constexpr std::size_t kLeastPartBytes = 4096;

/// Cuts messages into parts. Its one buffer is used again, because fresh pages for each image cost a fifth of what
/// publishing costs. Pure. Owner: one thread.
class PartCutter {
 public:
  /// `most_B`: largest size of a part, at least kLeastPartBytes.
  explicit PartCutter(std::size_t most_B);

  /// Calls `on_part` with each part of `message`, until it returns false. Returns whether all parts were taken.
  bool cut(const wire::Message& message, const std::function<bool(std::string_view part)>& on_part);

 private:
  std::size_t room_B_;
  std::string part_;
};

/// Joins the parts of each topic's messages. A message of which a part is missing is dropped. At most
/// wire::kMaxPayloadBytes are kept for each topic. Pure. Owner: one thread.
class PartJoiner {
 public:
  /// Adds a part of a message of `topic`; returns the message if it is whole now.
  [[nodiscard]] std::optional<wire::Message> add(const wire::Topic& topic, std::string_view part);

  [[nodiscard]] std::uint64_t malformed() const noexcept { return malformed_; }    ///< parts that no relay sends
  [[nodiscard]] std::uint64_t incomplete() const noexcept { return incomplete_; }  ///< messages that lost a part

 private:
  struct Growing {
    std::uint64_t sequence = 0;
    std::uint16_t next_part = 0;
    std::uint32_t whole_B = 0;
    std::string payload{};
  };
  std::map<std::string_view, Growing> growing_;  // by topic; absent: no message has begun
  std::uint64_t malformed_ = 0;
  std::uint64_t incomplete_ = 0;
};

}  // namespace telepalp::relay
