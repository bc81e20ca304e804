#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "clients/ar/messages/from_messages.h"
#include "codec/color_reader.h"
#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/message.h"

namespace telepalp::view {

/// Collects a server's messages and draws the newest depth image with the colour image and the station's state captured
/// within 20 ms of it. It uses no input, output, clock or thread. Owner: one thread.
class NewestInstant {
 public:
  /// How a message was used. NeedsKeyFrame: the message's topic cannot be decoded before its next key frame.
  /// Unreadable: the message is not of its topic's type, such as one that was cut short, or its colour image is
  /// damaged.
  enum class Taken { Yes, NotNeeded, NeedsKeyFrame, Unreadable };
  Taken take(const wire::Message& message);

  /// True if the newest depth image has a colour image and a camera model; if `with_touch`, also a station state.
  [[nodiscard]] bool is_complete(bool with_touch) const;
  /// The picture, with the touch if a station state is within 20 ms. Call picture() only if is_complete(false) is true.
  [[nodiscard]] ColorImage picture(int width_px, int height_px) const;

 private:
  Taken take_depth(const msg::DepthImage& image);
  Taken take_color(const wire::Message& message);
  Taken take_camera(const foxglove::CameraCalibration& info);
  Taken take_color_camera(const foxglove::CameraCalibration& info);
  Taken take_state(const msg::StationState& state);
  [[nodiscard]] const msg::StationState* state_at_capture() const;
  [[nodiscard]] const ColorImage* color_at_capture() const;

  struct Color {
    std::int64_t captured_ns = 0;
    ColorImage image;
  };
  codec::DepthReader reader_;
  codec::ColorReader color_reader_;
  RgbdFrame frame_;  ///< only its depth is used; `captured` is 0 before the first image
  std::int64_t captured_ns_ = 0;
  std::optional<Intrinsics> depth_camera_;
  std::optional<Intrinsics> color_camera_;
  bool color_registered_ = true;
  std::deque<Color> colors_;              ///< the newest 4
  std::deque<msg::StationState> states_;  ///< the newest 64: 0.6 s at 100 Hz
};

}  // namespace telepalp::view
