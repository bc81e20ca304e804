#pragma once

#include <optional>

#include "codec/video.h"
#include "proto/wire/key_frame_request.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::pipeline {

/// Encodes colour as video while a subscriber wants it. The first frame after end() is a key frame. Owner: the capture
/// thread.
class VideoStage {
 public:
  /// `kbit_per_s`: target rate, above 0.
  explicit VideoStage(int kbit_per_s) : kbit_per_s_(kbit_per_s) {}

  void set_rate(int kbit_per_s);
  void request_key_frame() noexcept { pacing_.requested = true; }
  /// The last encoded frame was not published, so the next one must be a key frame.
  void lost_frame() noexcept;
  /// Frees the encoder, because no subscriber wants video.
  void end() noexcept { encoder_.reset(); }

  /// The colour of `frame`. nullopt: it has none, or has more pixels than a video frame may have. `frame` is well
  /// formed.
  [[nodiscard]] std::optional<codec::EncodedVideo> encode(const RgbdFrame& frame);

 private:
  int kbit_per_s_;
  std::optional<codec::ColorVideoEncoder> encoder_;
  wire::KeyFramePacing pacing_;
};

}  // namespace telepalp::pipeline
