#pragma once

#include <string>
#include <vector>

#include "codec/depth_stream.h"
#include "haptic_station/core/surface_stage.h"

namespace telepalp::core {

inline constexpr int kWidth = 160;
inline constexpr int kHeight = 120;
inline const Intrinsics kCamera{.width = kWidth, .height = kHeight, .fx = 130, .fy = 130, .cx = 79.5, .cy = 59.5};
inline constexpr SessionTime kFirstImage{std::chrono::seconds(10)};
inline constexpr Nanoseconds kFrame{33'333'333};

/// A level patient that moves one millimetre towards the camera with each image.
inline DepthImage level_patient(int number) {
  return {.width = kWidth,
          .height = kHeight,
          .unit_m = 0.001,
          .samples = std::vector<std::uint16_t>(kWidth * kHeight, static_cast<std::uint16_t>(900 - number % 100))};
}

/// Images as they arrive from a server, 20 ms after their capture.
inline std::vector<ArrivedDepth> stream_of(codec::DepthMode mode, int images, int key_every) {
  codec::DepthEncoder encoder({.mode = mode, .key_every = key_every});
  std::vector<ArrivedDepth> stream;
  for (int i = 0; i < images; ++i) {
    const SessionTime captured = kFirstImage + i * kFrame;
    msg::DepthImage message;
    message.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
    message.set_sequence(static_cast<std::uint64_t>(i));
    message.set_width(kWidth);
    message.set_height(kHeight);
    message.set_unit_m(0.001);
    codec::EncodedDepth encoded = encoder.encode(level_patient(i));
    message.set_data(std::move(encoded.bytes));
    stream.push_back({.depth = wire::make_message(wire::kCameraDepth, captured, message, encoded.key_frame),
                      .camera = kCamera,
                      .received = captured + std::chrono::milliseconds(20)});
  }
  return stream;
}

inline SurfaceStage fast_stage() {
  return {*surface::surface_settings("fast"),
          [](const DepthImage&, const Intrinsics&) { return Transform<HapticBase, DepthCamera>{}; },
          {}};
}

}  // namespace telepalp::core
