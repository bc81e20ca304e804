#include "haptic_station/core/inside/ultrasound_stage.h"

#include <algorithm>
#include <utility>

#include "haptic_station/core/inside/ultrasound_image.h"
#include "haptic_station/loop/time_line.h"

namespace telepalp::core {
namespace {

Eigen::Vector3d moved_m(const loop::ObjectPlacements& objects, std::uint32_t effect) {
  const std::array<float, 3>& moved = objects.at(effect).moved;
  return {moved[0], moved[1], moved[2]};
}

}  // namespace

std::optional<UltrasoundStage::Job> UltrasoundStage::take(SessionTime now, const View& view) {
  const bool clock_went_back = loop::begins_new_time_line(now + kPeriod, due_);
  if (now < due_ && !clock_went_back) return std::nullopt;
  const bool on_time = now < due_ + kPeriod && !clock_went_back;
  due_ = (on_time ? due_ : now) + kPeriod;
  return Job{.view = view, .begun = now};
}

UltrasoundStage::Result UltrasoundStage::run(const Job& job, const StepTime& time) const {
  const View& view = job.view;
  const HeldProbe probe = held_probe(view.tick, view.haptic_from_camera);
  Result result{.image = probe_message(probe, settings_, view.haptic_from_camera), .begun = job.begun};
  result.image.set_stamp_ns(static_cast<std::uint64_t>(view.tick.stamp_ns));
  result.image.set_surface_captured_ns(static_cast<std::uint64_t>(view.tick.surface_captured_ns));
  if (probe.on_skin) {
    std::vector<ultrasound::PlacedLayer> placed;
    for (const auto& [solid, effect] : layers_) placed.push_back({solid.get(), moved_m(view.objects, effect)});
    set_image(result.image, ultrasound::b_mode(placed, probe.pose, settings_));
  }
  result.done = time(StageStep::Done);
  if (probe.on_skin) result.image.set_compute_ms(to_milliseconds(result.done - job.begun));
  return result;
}

std::optional<msg::UltrasoundImage> UltrasoundStage::hand_over(Result result, SessionTime now) {
  if (loop::begins_new_time_line(now, result.begun)) return std::nullopt;
  return std::move(result.image);
}

}  // namespace telepalp::core
