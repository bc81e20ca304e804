#include "haptic_station/station/parts/inside_view.h"

#include <algorithm>
#include <utility>

namespace telepalp::station {
namespace {

constexpr std::chrono::milliseconds kImagePeriod{40};  // /station/ultrasound at 25 Hz

}  // namespace

void InsideView::start(const scenes::Scene& scene, Handlers handlers) {
  if (scene.layers.empty() && !scene.probe)
    structures_.emplace();
  else
    thread_.emplace(scene, std::move(handlers));
}

std::optional<msg::InnerStructures> InsideView::structures(
    SessionTime now, const Transform<HapticBase, DepthCamera>& haptic_from_camera) const {
  if (!structures_) return std::nullopt;
  msg::InnerStructures placed = *structures_;
  placed.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  set_place(placed, haptic_from_camera);
  return placed;
}

void InsideView::look(const loop::TickSample& tick, const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
  const auto now = std::chrono::steady_clock::now();
  if (!thread_ || now < next_image_) return;
  next_image_ = std::max(next_image_ + kImagePeriod, now);  // the period on average, however late the timer comes
  thread_->offer({tick, haptic_from_camera, objects_});
}

}  // namespace telepalp::station
