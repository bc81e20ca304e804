#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

#include "proto/wire/topics.h"

namespace telepalp::pipeline {

/// Requests of key frames, by topic, from any thread to the capture thread. Several requests of one topic count as one.
class KeyFrameRequests {
 public:
  void request(std::string_view topic) noexcept {
    if (const std::size_t at = index_of(topic); at < requested_.size()) requested_[at] = true;
  }
  /// True if a key frame of `topic` was requested since the last call.
  [[nodiscard]] bool take(std::string_view topic) noexcept {
    const std::size_t at = index_of(topic);
    return at < requested_.size() && requested_[at].exchange(false);
  }

 private:
  static std::size_t index_of(std::string_view topic) noexcept {
    return static_cast<std::size_t>(std::ranges::find(wire::kTopics, topic, &wire::Topic::name) -
                                    wire::kTopics.begin());
  }

  std::array<std::atomic<bool>, wire::kTopics.size()> requested_{};  // as in wire::kTopics
};

}  // namespace telepalp::pipeline
