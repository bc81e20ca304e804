#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "codec/depth_stream.h"
#include "proto/wire/message.h"
#include "proto/wire/session_clock.h"
#include "server/capture/capture_source.h"
#include "server/pipeline/paced_encoder.h"
#include "server/pipeline/video_stage.h"
#include "server/pipeline/wanted.h"
#include "server/pipeline/window_stage.h"

namespace telepalp::pipeline {

struct EncodeOptions {
  codec::DepthStreamSettings depth{.mode = codec::DepthMode::Fast, .key_every = 12};
  int jpeg_quality = 85;
  int video_kbit_per_s = 800;  ///< target rate of colour as video
};

/// `asked`, made smaller for a line that other flows use (link::ContentLevel). Level 1: fast depth becomes intra, which
/// is as exact, and colour loses quality, as pictures and as video. From level 2: colour loses more, and near-lossless
/// depth has twice the bound.
[[nodiscard]] EncodeOptions shrunk(EncodeOptions asked, std::size_t level) noexcept;

/// Turns the frames of a capture source into the messages of /camera/…. Depth is published before colour, because touch
/// needs it first. Owner: the capture thread; the handlers are called on it.
class CameraPipeline {
 public:
  struct Handlers {
    std::function<bool(wire::Message)> publish;  ///< passes a message on; false: it was dropped
    /// True if a key frame of `topic` was requested since the last call for it.
    std::function<bool(std::string_view topic)> take_key_frame_request;
    /// False: a lost image cannot be repaired in time, so that each depth image must be a key frame. Empty: always
    /// true.
    std::function<bool()> may_predict{};
    std::function<std::size_t()> content_level{};  ///< for shrunk(); empty: always 0
    std::function<Wanted()> wanted{};  ///< called once for each image; empty: pictures and whole depth images
  };
  CameraPipeline(capture::CaptureSource& source, std::string source_name, EncodeOptions options,
                 wire::SessionClock clock, Handlers handlers);

  /// Waits at most 0.1 s for a frame and publishes the frame. Publishes the source's state when it changes, and each
  /// second. False: the source has ended and its last state is published.
  [[nodiscard]] bool step();

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }

 private:
  void publish_frame(const RgbdFrame& frame);
  void publish_calibration_when_due(const RgbdFrame& frame);
  void publish_status_when_due();
  void measure_rate(SessionTime now);
  void publish_depth(const RgbdFrame& frame, const Wanted& wanted);
  void publish_whole(const RgbdFrame& frame);
  void publish_window(const RgbdFrame& frame, const std::optional<DepthWindow>& window);
  bool publish_depth_as(const wire::Topic& topic, const RgbdFrame& frame, codec::EncodedDepth coded);
  void publish_color(const RgbdFrame& frame, ColorWanted wanted);
  void publish_video(const RgbdFrame& frame);
  void shrink_when_asked();
  bool publish(wire::Message message);
  [[nodiscard]] bool must_not_predict() const;

  capture::CaptureSource& source_;
  std::string source_name_;
  EncodeOptions asked_;
  EncodeOptions options_;  ///< shrunk(asked_, level_)
  std::size_t level_ = 0;
  wire::SessionClock clock_;
  Handlers handlers_;
  PacedEncoder<codec::DepthEncoder> whole_;  // of /camera/depth
  VideoStage video_;
  WindowStage window_;

  std::uint64_t frames_ = 0;
  std::string refused_;  // why the last frame could not be sent; empty: it was sent
  bool color_registered_ = true;
  std::optional<CameraModel> calibration_;  // as last published
  SessionTime calibration_at_{};
  std::optional<capture::CaptureState> state_;  // last published one
  std::string detail_;
  SessionTime status_at_{};
  double frames_per_s_ = 0.0;
  SessionTime rate_since_;
  std::uint64_t frames_at_rate_ = 0;
};

}  // namespace telepalp::pipeline
