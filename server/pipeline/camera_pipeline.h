#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/message.h"
#include "proto/wire/session_clock.h"
#include "server/capture/capture_source.h"
#include "server/pipeline/encode_options.h"
#include "server/pipeline/grade_stage.h"
#include "server/pipeline/wanted.h"

namespace telepalp::pipeline {

/// Turns the frames of a capture source into the messages of /camera/…. Depth is published before colour, because touch
/// needs it first. Owner: the capture thread; the handlers are called on it.
class CameraPipeline {
 public:
  struct Handlers {
    /// Passes a message on; false: it was dropped. `grade`: Full for a message that is not an image.
    std::function<bool(wire::Message, plan::Grade grade)> publish;
    /// True if a key frame of `topic` was requested since the last call for it.
    std::function<bool(std::string_view topic)> take_key_frame_request;
    /// False: a lost image cannot be repaired in time, so that each depth image must be a key frame. Empty: always
    /// true.
    std::function<bool()> may_predict{};
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
  void publish_images(const RgbdFrame& frame);
  void pass_key_frame_requests_on();
  bool publish(wire::Message message, plan::Grade grade = plan::Grade::Full);
  [[nodiscard]] GradeStage stage_of(plan::Grade grade, const EncodeOptions& options);

  capture::CaptureSource& source_;
  std::string source_name_;
  wire::SessionClock clock_;
  Handlers handlers_;
  std::array<GradeStage, plan::kGrades.size()> stages_;  // in kPublishingOrder
  std::string given_up_;                                 // Wanted::given_up of the newest image

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
