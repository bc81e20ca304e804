#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "codec/depth_stream.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// Reads some frames of a stream and passes over others, in the stream's order. Of what was passed over only that is
/// decoded on which a frame that is read depends, so that passing over frames that stand alone costs nothing.
class DepthReader {
 public:
  void pass_over(std::string packet);

  /// As DepthDecoder::decode(), with what was passed over before it.
  [[nodiscard]] Result<DepthImage> read(std::span<const std::byte> packet);

 private:
  void catch_up();
  void forget_passed();

  DepthDecoder decoder_;
  std::vector<std::string> passed_;  // from the last frame that stood alone, or that was read; bounded
  std::size_t passed_bytes_ = 0;
};

}  // namespace telepalp::codec
