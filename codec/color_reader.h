#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "codec/video.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// Decodes the colour images of one camera, pictures and video. The caller passes each image to read() or skip(), in
/// order. An image that is predicted from a missing one is refused.
class ColorReader {
 public:
  /// `format`: kVideoFormat, or that of a picture ("jpeg"). `number`: of the message within its topic; a gap in the
  /// numbers of video frames means lost frames; 0: not known. Error: the image is damaged, of another coding, or
  /// predicted from a missing one.
  [[nodiscard]] Result<ColorImage> read(std::string_view format, std::span<const std::byte> bytes,
                                        std::uint64_t number);

  /// Takes in an image that is not needed itself, because later ones may be predicted from it.
  void skip(std::string_view format, std::span<const std::byte> bytes, std::uint64_t number);

 private:
  [[nodiscard]] Result<void> take_video(std::span<const std::byte> bytes, std::uint64_t number);

  ColorVideoDecoder video_;
  std::uint64_t last_number_ = 0;
};

}  // namespace telepalp::codec
