#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/link/datagram_link.h"
#include "proto/words/time.h"

namespace telepalp::wire {

/// Decides at the sender when a receiver's broken chain of predicted frames is worth a key frame. A receiver repeats
/// its wish in each report until it has a key frame, so that a wish means nothing while a key frame is on its way. This
/// is the one place that chooses between predicted frames and key frames by what the path can do. Pure.
class KeyFrameRepair {
 public:
  /// A key frame of `channel` starts to be sent at `now`.
  void key_frame_sent(std::uint8_t channel, SessionTime now) noexcept { sent_[channel] = now; }

  /// The receiver reports at `now` that it cannot go on in `channel`. True: request a key frame.
  [[nodiscard]] bool is_due(std::uint8_t channel, SessionTime now, Nanoseconds round_trip) const noexcept {
    return !sent_[channel] || now - *sent_[channel] > round_trip + kTransfer;
  }

 private:
  static constexpr Nanoseconds kTransfer = std::chrono::milliseconds(60);  ///< of the frame itself, with a repair
  std::array<std::optional<SessionTime>, link::kMostChannels> sent_{};
};

}  // namespace telepalp::wire
