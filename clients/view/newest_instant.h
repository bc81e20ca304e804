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

/// The newest instant of which depth and its camera's model have come, from the messages of a server in any order.
/// Pure. Owner: one thread.
class NewestInstant {
 public:
  /// What became of a message.
  enum class Taken { Yes, NotNeeded, NeedsKeyFrame };
  Taken take(const wire::Message& message);

  /// True once it can be drawn. `with_touch`: only with the station's state of about that instant.
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
  RgbdFrame frame_;  ///< depth alone; captured is 0 without an image
  std::int64_t captured_ns_ = 0;
  std::optional<Intrinsics> depth_camera_;
  std::optional<Intrinsics> color_camera_;
  bool color_registered_ = true;
  std::deque<Color> colors_;              ///< the newest few
  std::deque<msg::StationState> states_;  ///< of the last half second
};

}  // namespace telepalp::view
