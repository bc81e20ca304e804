#pragma once

#include <algorithm>
#include <chrono>

#include "proto/words/voice/voice_packet.h"

namespace telepalp::voice {

/// Slows down a device that has no clock of its own: ALSA can play to a file or to nothing, and takes sound as fast as
/// a program gives it. Hardware makes the program wait for each block, and is left alone.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// A block of 20 ms will be transferred now.
  void before_block() noexcept { began_ = Clock::now(); }
  /// The block was transferred. Returns until when to sleep; in the past if the device is no faster than time.
  [[nodiscard]] Clock::time_point after_block() noexcept {
    const Clock::time_point now = Clock::now();
    due_ = std::max(due_ + kVoiceFrameTime, now - kBehind);
    if (now - began_ >= kOwnPace) due_ = std::min(due_, now + kAhead - std::chrono::milliseconds(5));
    return due_ - kAhead;
  }

 private:
  static constexpr std::chrono::milliseconds kBehind{100};  // a device that was late does not catch up more than this
  static constexpr std::chrono::milliseconds kAhead{60};    // the device's buffer
  static constexpr std::chrono::milliseconds kOwnPace{8};   // a wait that only hardware causes
  Clock::time_point due_ = Clock::now();
  Clock::time_point began_ = due_;
};

}  // namespace telepalp::voice
