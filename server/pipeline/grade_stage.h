#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "codec/depth_stream.h"
#include "proto/wire/message.h"
#include "proto/wire/session_clock.h"
#include "proto/words/rgbd_frame.h"
#include "server/pipeline/encode_options.h"
#include "server/pipeline/paced_encoder.h"
#include "server/pipeline/video_stage.h"
#include "server/pipeline/wanted.h"
#include "server/pipeline/window_stage.h"

namespace telepalp::pipeline {

/// The streams of images for which a subscriber has requested a key frame.
struct RequestedKeyFrames {
  bool whole = false;
  bool window = false;
  bool video = false;
};

/// Encodes the images of one grade. Owner: the capture thread.
class GradeStage {
 public:
  /// `publish` passes a message on; false: it was dropped. `asked`: the server's options.
  GradeStage(const EncodeOptions& asked, const wire::SessionClock& clock, std::function<bool(wire::Message)> publish);

  /// From the next image on, images are made as `wanted` says. Frees the encoders of streams that nobody takes.
  void want(const GradeWanted& wanted);
  void request_key_frames(const RequestedKeyFrames& requested) noexcept;
  /// The next image of each depth stream is a key frame, because the last one must not be its reference.
  void forget_depth() noexcept;

  /// Publishes the depth of `frame`, the camera's image `number`, which is well formed. `window`: where depth with a
  /// window is exact; nullopt: everywhere.
  void publish_depth(const RgbdFrame& frame, std::uint64_t number, const std::optional<DepthWindow>& window);
  void publish_color(const RgbdFrame& frame, std::uint64_t number);

 private:
  [[nodiscard]] bool is_left_out_by_level(std::uint64_t number) const noexcept;
  void publish_whole(const RgbdFrame& frame);
  void publish_window(const RgbdFrame& frame, const std::optional<DepthWindow>& window);
  bool publish_depth_as(const wire::Topic& topic, const RgbdFrame& frame, codec::EncodedDepth coded);
  void publish_video(const RgbdFrame& frame);

  EncodeOptions asked_;
  EncodeOptions options_;  // with(asked_, wanted_.settings)
  wire::SessionClock clock_;
  std::function<bool(wire::Message)> publish_;
  GradeWanted wanted_;
  PacedEncoder<codec::DepthEncoder> whole_;  // of /camera/depth
  VideoStage video_;
  WindowStage window_;
  std::uint64_t windows_ = 0;  // published depth images with a window
};

}  // namespace telepalp::pipeline
