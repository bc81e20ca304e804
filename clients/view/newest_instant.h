#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "clients/ar/messages/from_messages.h"
#include "codec/depth_stream.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/message.h"

namespace telepalp::view {

/// Collects a server's messages, in any order, and draws the newest instant that has depth, colour and a camera model.
/// No input, output, clock or thread of its own. Owner: one thread.
class NewestInstant {
 public:
  /// How a message was used.
  enum class Taken { Yes, NotNeeded, NeedsKeyFrame };
  Taken take(const wire::Message& message);

  /// True once the instant can be drawn. `with_touch`: it also needs a state of the station within 20 ms of it.
  [[nodiscard]] bool is_complete(bool with_touch) const;
  /// The picture of the instant. Call it only when is_complete().
  [[nodiscard]] ColorImage picture(int width_px, int height_px) const;

 private:
  Taken take_depth(const msg::DepthImage& image);
  [[nodiscard]] const msg::StationState* state_at_capture() const;
  [[nodiscard]] const ColorImage* color_at_capture() const;

  struct Color {
    std::int64_t captured_ns = 0;
    ColorImage image;
  };
  codec::DepthReader reader_;
  RgbdFrame frame_;  ///< only its depth is used; `captured` is 0 before the first image
  std::int64_t captured_ns_ = 0;
  std::optional<Intrinsics> depth_camera_;
  std::optional<Intrinsics> color_camera_;
  bool color_registered_ = true;
  std::deque<Color> colors_;              ///< the newest few
  std::deque<msg::StationState> states_;  ///< of the last half second
};

}  // namespace telepalp::view
