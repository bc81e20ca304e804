#pragma once

#include <optional>

#include "codec/video.h"
#include "proto/words/rgbd_frame.h"
#include "server/pipeline/paced_encoder.h"

namespace telepalp::pipeline {

/// Encodes colour as video. Owner: the capture thread.
class VideoStage : public PacedEncoder<codec::ColorVideoEncoder> {
 public:
  /// `kbit_per_s`: target rate, above 0.
  explicit VideoStage(int kbit_per_s) : kbit_per_s_(kbit_per_s) {}

  void set_rate(int kbit_per_s);

  /// The colour of `frame`. nullopt: it has none, or has more pixels than a video frame may have. `frame` is well
  /// formed.
  [[nodiscard]] std::optional<codec::EncodedVideo> encode(const RgbdFrame& frame);

 private:
  int kbit_per_s_;
};

}  // namespace telepalp::pipeline
