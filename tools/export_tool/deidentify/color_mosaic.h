#pragma once

#include <optional>
#include <string>

#include "codec/color_reader.h"
#include "codec/video.h"
#include "proto/wire/message.h"

namespace telepalp::export_tool {

/// Number of squares across the width of a blurred image.
inline constexpr int kMosaicColumns = 16;

/// `color` with each square of 1/16 of its width filled by the square's mean colour.
[[nodiscard]] ColorImage mosaic(const ColorImage& color);

/// A colour message, blurred.
struct BlurredColor {
  std::string payload;
  bool key_frame = true;
};

/// Blurs the colour images of a session, pictures and video, by mosaic(). The caller passes all of them in order,
/// because video frames are predicted from earlier ones.
class ColorBlur {
 public:
  /// nullopt: the image cannot be decoded, so it cannot be blurred and must be removed.
  [[nodiscard]] std::optional<BlurredColor> blurred(const wire::Message& message);

 private:
  codec::ColorReader pictures_;
  codec::ColorReader video_;
  codec::ColorVideoEncoder encoder_{codec::ColorVideoSettings{}};
};

}  // namespace telepalp::export_tool
