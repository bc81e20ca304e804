#pragma once

#include <chrono>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::codec {

/// Decides when a receiver that cannot decode asks for a key frame: at the first failure, then at a fixed interval
/// while decoding still fails.
class KeyFrameRequest {
 public:
  /// Time between requests: a key frame may be three frames away, and then needs one network delay to arrive.
  static constexpr Nanoseconds kInterval = std::chrono::milliseconds(300);

  /// A frame could not be decoded at `now`. Returns true when a request is due.
  [[nodiscard]] bool failed(SessionTime now) noexcept {
    if (requested_ && now - *requested_ < kInterval && now >= *requested_) return false;
    requested_ = now;
    return true;
  }
  void succeeded() noexcept { requested_.reset(); }

 private:
  std::optional<SessionTime> requested_;
};

}  // namespace telepalp::codec
