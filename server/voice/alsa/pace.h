#pragma once

#include <algorithm>
#include <chrono>

#include "proto/words/voice/voice_packet.h"

namespace telepalp::voice {

/// Keeps a device to the pace of time. Hardware has its own pace, which is left alone: it is seen by the wait for each
/// block. A device of ALSA that is a file, or nothing at all, gives and takes sound as fast as a program asks.
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
  static constexpr std::chrono::milliseconds kOwnPace{8};   // of waiting for a block
  Clock::time_point due_ = Clock::now();
  Clock::time_point began_ = due_;
};

}  // namespace telepalp::voice
