#include "tests/bench/hand/feed.h"

#include <algorithm>
#include <utility>

#include "haptic_station/core/virtual_driver.h"

namespace telepalp::bench::hand {
Feed::Feed(Settings settings)
    : settings_(std::move(settings)),
      stage_(
          settings_.builder,
          [place = settings_.haptic_from_camera](const DepthImage&, const Intrinsics&) { return place; },
          settings_.effects),
      random_(settings_.link.seed),
      loss_(settings_.link.loss, settings_.link.burst_frames) {}

void Feed::capture(double time_s) {
  const Link& link = settings_.link;
  const double jitter_s = std::min(link.jitter_s, link.one_way_s);
  const double arrives_s = time_s + link.one_way_s + random_.uniform(-jitter_s, jitter_s);
  if (loss_.lost(random_.uniform())) return;
  Frame frame{time_s, arrives_s, settings_.patient->depth_of(settings_.pose(time_s), at_time(time_s))};
  if (!settings_.damage(time_s, frame.depth)) return;
  const auto later = std::upper_bound(on_the_way_.begin(), on_the_way_.end(), arrives_s,
                                      [](double at_s, const Frame& other) { return at_s < other.arrives_s; });
  on_the_way_.insert(later, std::move(frame));
}

std::shared_ptr<const surface::SurfaceSnapshot> Feed::step(double time_s, const Point<DepthCamera>& device) {
  for (; static_cast<double>(frames_) / settings_.frame_hz <= time_s + 1e-9; ++frames_)
    capture(static_cast<double>(frames_) / settings_.frame_hz);
  std::shared_ptr<const surface::SurfaceSnapshot> newest;
  while (!on_the_way_.empty() && on_the_way_.front().arrives_s <= time_s) {
    Frame& frame = on_the_way_.front();
    newest_captured_s_ = std::max(newest_captured_s_, frame.captured_s);
    stage_.arrived(core::seen_image(std::move(frame.depth), settings_.patient->settings().camera,
                                    at_time(frame.captured_s), static_cast<std::uint64_t>(frames_), at_time(time_s)));
    if (auto result = core::run_at_once(stage_, at_time(time_s), settings_.haptic_from_camera * device);
        result->surface)
      newest = std::move(result->surface->snapshot);
    on_the_way_.pop_front();
  }
  return newest;
}

}  // namespace telepalp::bench::hand
