#pragma once

#include <optional>

#include "codec/depth_stream.h"
#include "proto/wire/key_frame_request.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::pipeline {

/// Encodes depth that is exact in the window for the hand, while a subscriber wants it. The first image after end() is
/// a key frame. Owner: the capture thread.
class WindowStage {
 public:
  /// `depth`: the settings of whole images. A window's images are predicted from earlier ones if those are.
  explicit WindowStage(const codec::DepthStreamSettings& depth);

  void request_key_frame() noexcept { pacing_.requested = true; }
  /// The last encoded frame was not published, or must not be a reference: the next one is a key frame.
  void lost_frame() noexcept;
  /// Frees the encoder, because no subscriber wants windows.
  void end() noexcept { encoder_.reset(); }

  /// The depth of `frame`, exact in the part of `window` that lies in the image, and everywhere if there is none, or if
  /// the source's own depth is near-lossless: then no part of it is exact. `frame` is well formed.
  [[nodiscard]] codec::EncodedDepth encode(const RgbdFrame& frame, const std::optional<DepthWindow>& window);

 private:
  codec::DepthStreamSettings settings_;
  std::optional<codec::DepthEncoder> encoder_;
  wire::KeyFramePacing pacing_;
};

}  // namespace telepalp::pipeline
