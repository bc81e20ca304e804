#pragma once

#include <optional>

#include "haptic_station/core/stage_step.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/surface/touch/touch.h"

namespace telepalp::core {

/// The collision detection of paper S1 (docs/sources.md): 100 times a second it finds the surface point nearest to the
/// device, on a surface whose evaluation is too slow or not real-time safe for the haptic thread. The tangent plane at
/// this point is the surface that the haptic thread adopts. It runs only if the surface setting is of this kind. Owner:
/// one thread.
class CollisionStage {
 public:
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(10);  // S1 II.C: 100 Hz

  struct Job {
    SessionTime begun{};
    std::optional<loop::TouchableSurface> newer;  ///< a surface that came since the last job
    Point<HapticBase> device;                     ///< its position in H
  };
  struct Result {
    std::optional<loop::TouchableSurface> plane;  ///< numbered from 1; nullopt: no surface has come yet
    SessionTime done{};
  };

  [[nodiscard]] std::optional<Job> take(SessionTime now, std::optional<loop::TouchableSurface> newer,
                                        const Point<HapticBase>& device) const {
    return Job{.begun = now, .newer = std::move(newer), .device = device};
  }
  [[nodiscard]] Result run(const Job& job, const StepTime& time);

 private:
  surface::Touch touch_;
  loop::TouchableSurface seen_;  // touch_ refers to it
  SessionTime latest_{};         // begin of the last job
  std::uint64_t planes_ = 0;
};

}  // namespace telepalp::core
