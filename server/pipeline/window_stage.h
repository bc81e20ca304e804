#pragma once

#include <optional>

#include "codec/depth_stream.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/rgbd_frame.h"
#include "server/pipeline/paced_encoder.h"

namespace telepalp::pipeline {

/// Encodes depth that is exact in the window for the hand. Owner: the capture thread.
class WindowStage : public PacedEncoder<codec::DepthEncoder> {
 public:
  /// `depth`: the settings of whole images. Images with a window are predicted from earlier ones if whole images are.
  explicit WindowStage(const codec::DepthStreamSettings& depth);

  /// The depth of `frame`, coded exactly in the part of `window` that lies in the image. It is coded exactly everywhere
  /// if there is no such part, or if the source's depth is itself near-lossless, so that no part of it is exact.
  /// `frame` is well formed.
  [[nodiscard]] codec::EncodedDepth encode(const RgbdFrame& frame, const std::optional<DepthWindow>& window);

 private:
  codec::DepthStreamSettings settings_;
};

}  // namespace telepalp::pipeline
