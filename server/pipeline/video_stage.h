#pragma once

#include <optional>

#include "codec/video.h"
#include "proto/wire/key_frame_request.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::pipeline {

/// Encodes colour as video while somebody wants it. The first frame that somebody wants again is a key frame. Owner:
/// the capture thread.
class VideoStage {
 public:
  /// `kbit_per_s`: target rate, above 0.
  explicit VideoStage(int kbit_per_s) : kbit_per_s_(kbit_per_s) {}

  void set_rate(int kbit_per_s);
  void request_key_frame() noexcept { pacing_.requested = true; }
  /// The frame was not passed on, so that the next one must be a key frame.
  void lost_frame() noexcept;
  /// Nobody wants video.
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
