#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/link/datagram_link.h"
#include "proto/words/time.h"

namespace telepalp::wire {

/// Decides at the sender whether a receiver's request for a key frame is passed on to the encoder. A receiver repeats
/// the request in each report until it has a key frame. A request is therefore ignored while the last key frame may
/// still be on its way. Pure.
class KeyFrameRepair {
 public:
  /// A key frame of `channel` starts to be sent at `now`.
  void key_frame_sent(std::uint8_t channel, SessionTime now) noexcept { sent_[channel] = now; }

  /// The receiver reports at `now` that it cannot decode `channel`. True: request a key frame from the encoder.
  [[nodiscard]] bool is_due(std::uint8_t channel, SessionTime now, Nanoseconds round_trip) const noexcept {
    return !sent_[channel] || now - *sent_[channel] > round_trip + kTransfer;
  }

 private:
  static constexpr Nanoseconds kTransfer = std::chrono::milliseconds(60);  ///< time to send and once repair a key frame
  std::array<std::optional<SessionTime>, link::kMostChannels> sent_{};
};

}  // namespace telepalp::wire
