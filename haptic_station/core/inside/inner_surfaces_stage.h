#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "haptic_station/core/inside/inner_surfaces.h"
#include "haptic_station/core/stage_step.h"

namespace telepalp::core {

/// Makes what viewers draw of a scene's layers, once. take() and hand_over() belong to one thread; run() may be called
/// on another one, and uses nothing of the stage.
class InnerSurfacesStage {
 public:
  struct Job {
    std::vector<InnerLayer> layers;
  };
  struct Result {
    std::optional<InnerSurfaces> made;  ///< nullopt: the run was stopped
    SessionTime done{};
  };

  /// Without layers there is no job, and the message is empty from the beginning: it removes the surfaces that an
  /// earlier station published.
  explicit InnerSurfacesStage(std::vector<InnerLayer> layers);

  /// All layers, as the only job; nullopt: they were taken, or there are none.
  [[nodiscard]] std::optional<Job> take(SessionTime now);
  [[nodiscard]] static Result run(const Job& job, const StepTime& time, const std::stop_token& stop = {});
  /// Keeps the surfaces. Returns the layers that are not drawn, as InnerSurfaces::left_out.
  std::vector<std::string> hand_over(Result result, SessionTime now);

  /// The message of /station/inside, with the camera where it is now; nullopt: the surfaces are not made yet.
  [[nodiscard]] std::optional<msg::InnerStructures> placed(
      SessionTime now, const Transform<HapticBase, DepthCamera>& haptic_from_camera) const;

 private:
  std::vector<InnerLayer> layers_;
  std::optional<msg::InnerStructures> made_;
};

}  // namespace telepalp::core
