#include "haptic_station/core/inside/inner_surfaces_stage.h"

#include <utility>

namespace telepalp::core {

InnerSurfacesStage::InnerSurfacesStage(std::vector<InnerLayer> layers) : layers_(std::move(layers)) {
  if (layers_.empty()) made_.emplace();
}

std::optional<InnerSurfacesStage::Job> InnerSurfacesStage::take(SessionTime) {
  if (layers_.empty()) return std::nullopt;
  return Job{std::exchange(layers_, {})};
}

InnerSurfacesStage::Result InnerSurfacesStage::run(const Job& job, const StepTime& time, const std::stop_token& stop) {
  Result result{.made = inner_structures(job.layers, stop)};
  result.done = time(StageStep::Done);
  return result;
}

std::vector<std::string> InnerSurfacesStage::hand_over(Result result, SessionTime) {
  if (!result.made) return {};
  made_ = std::move(result.made->drawn);
  return std::move(result.made->left_out);
}

std::optional<msg::InnerStructures> InnerSurfacesStage::placed(
    SessionTime now, const Transform<HapticBase, DepthCamera>& haptic_from_camera) const {
  if (!made_) return std::nullopt;
  msg::InnerStructures placed = *made_;
  placed.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  set_place(placed, haptic_from_camera);
  return placed;
}

}  // namespace telepalp::core
