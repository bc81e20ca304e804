#pragma once

#include <optional>
#include <vector>

#include "haptic_station/core/inside/inner_surfaces.h"
#include "haptic_station/core/stage_step.h"
#include "haptic_station/loop/body_frame.h"
#include "haptic_station/loop/tick_sample.h"
#include "haptic_station/ultrasound/b_mode.h"

namespace telepalp::core {

/// Makes the image of the ultrasound probe that the hand holds. take() and hand_over() belong to one thread; run() may
/// be called on another one.
class UltrasoundStage {
 public:
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(40);  // 25 Hz

  /// The probe at a tick, the camera's pose, and how far the layers have moved with the body.
  struct View {
    loop::TickSample tick;
    Transform<HapticBase, DepthCamera> haptic_from_camera;
    loop::ObjectPlacements objects{};  ///< one for each effect, in the scene's order
  };
  struct Job {
    View view;
    SessionTime begun{};
  };
  struct Result {
    msg::UltrasoundImage image;  ///< empty if the probe is not on the skin
    SessionTime begun{};
    SessionTime done{};
  };

  UltrasoundStage(std::vector<InnerLayer> layers, const ultrasound::BModeSettings& settings)
      : layers_(std::move(layers)), settings_(settings) {}

  /// The view as a job, if an image is due: one in each period of 40 ms. Periods that pass during a run are left out.
  [[nodiscard]] std::optional<Job> take(SessionTime now, const View& view);
  [[nodiscard]] Result run(const Job& job, const StepTime& time) const;
  /// The message of /station/ultrasound; nullopt: the session clock has stepped back since the run began, so the image
  /// belongs to another session.
  [[nodiscard]] static std::optional<msg::UltrasoundImage> hand_over(Result result, SessionTime now);

 private:
  const std::vector<InnerLayer> layers_;
  const ultrasound::BModeSettings settings_;
  SessionTime due_{};  // when the next image may begin
};

}  // namespace telepalp::core
