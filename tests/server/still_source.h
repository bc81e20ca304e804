#pragma once

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "server/capture/capture_source.h"

namespace telepalp::server {

/// A frame whose depth is a ramp and whose colour has a fine pattern.
inline RgbdFrame small_frame(std::uint64_t sequence, SessionTime captured) {
  RgbdFrame frame;
  frame.captured = captured;
  frame.sequence = sequence;
  frame.camera.depth = {.width = 64, .height = 48, .fx = 60.0, .fy = 61.0, .cx = 31.5, .cy = 23.5};
  frame.camera.color = frame.camera.depth;
  frame.depth = {.width = 64, .height = 48, .unit_m = 0.001, .samples = {}};
  for (int i = 0; i < 64 * 48; ++i) frame.depth.samples.push_back(static_cast<std::uint16_t>(500 + i));
  frame.color = {.width = 64, .height = 48, .rgb = {}};
  for (int i = 0; i < 3 * 64 * 48; ++i) frame.color.rgb.push_back(static_cast<std::uint8_t>(37 * i));
  return frame;
}

/// Gives `frames` small frames, one each `period`, then ends.
class StillSource : public capture::CaptureSource {
 public:
  StillSource(std::uint64_t frames, Nanoseconds period, wire::SessionClock clock)
      : frames_(frames), period_(period), clock_(clock) {}

  std::optional<RgbdFrame> next(Nanoseconds) override {
    if (given_ == frames_) return std::nullopt;
    std::this_thread::sleep_for(period_);
    ++given_;
    return small_frame(given_, clock_.now());
  }
  capture::CaptureState state() const override {
    return given_ == frames_ ? capture::CaptureState::Ended : capture::CaptureState::Live;
  }
  std::string detail() const override { return "a still picture"; }

 private:
  std::uint64_t frames_;
  Nanoseconds period_;
  wire::SessionClock clock_;
  std::uint64_t given_ = 0;
};

}  // namespace telepalp::server
