#pragma once

#include <optional>

#include "proto/words/time.h"

namespace telepalp::codec {

/// When a receiver that cannot read on asks for a key frame: at once, and again while nothing can be read.
class KeyAsking {
 public:
  /// From one asking to the next: the key frame may be three frames off, and then a way through the network.
  static constexpr Nanoseconds kAgain = std::chrono::milliseconds(300);

  /// A frame could not be read at `now`. True: ask.
  [[nodiscard]] bool failed(SessionTime now) noexcept {
    if (asked_ && now - *asked_ < kAgain && now >= *asked_) return false;
    asked_ = now;
    return true;
  }
  void succeeded() noexcept { asked_.reset(); }

 private:
  std::optional<SessionTime> asked_;
};

}  // namespace telepalp::codec
