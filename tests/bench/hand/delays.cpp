#include "tests/bench/hand/delays.h"

#include <algorithm>
#include <cmath>

namespace telepalp::bench::hand {

std::string delay_name(std::size_t delay) { return std::to_string(std::lround(1e3 * kDelays_s[delay])) + " ms"; }

Link link_before_delays(double loss) noexcept {
  return {.one_way_s = kJitter_s, .jitter_s = kJitter_s, .loss = loss, .seed = 5};
}

std::vector<DelayedStation> stations_at_delays(const Transform<HapticBase, DepthCamera>& placed,
                                               const std::function<std::unique_ptr<Person>()>& person) {
  std::vector<DelayedStation> all;
  for (const auto anchor : {effects::SkinAnchor::FollowsSurface, effects::SkinAnchor::Sliding})
    for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
      StationSettings settings = with_skin(anchor);
      settings.control.limits.continuous_N = settings.control.limits.peak_N;
      settings.extra_delay_s = kDelays_s[delay] - kJitter_s;
      all.push_back({BenchStation(settings, placed, person()), delay});
    }
  return all;
}

void run_together(Feed& feed, std::span<DelayedStation> stations, double seconds,
                  const std::function<void(std::size_t index, const Tick& tick)>& judge) {
  for (std::int64_t i = 0; i < std::llround(seconds / kTick_s); ++i) {
    const double t = static_cast<double>(i) * kTick_s;
    const auto snapshot = feed.step(t, stations.front().station.device_camera());
    const capture::TrueSurface truth = feed.truth(t);
    for (std::size_t index = 0; index < stations.size(); ++index) {
      stations[index].station.receive(snapshot, t);
      judge(index, stations[index].station.step(t, truth));
    }
  }
}

Eigen::Vector3d newest_image_N(const Feed& feed, const Tick& tick, const Transform<HapticBase, DepthCamera>& placed) {
  const capture::TrueSurface shown = feed.truth(tick.time_s - tick.surface_age_s);
  const auto foot = shown.closest_to(placed.inverse() * Point<HapticBase>{tick.device_m});
  if (!foot) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d normal = (placed * foot->normal).v;
  const double depth_m = normal.dot((placed * foot->at).m - tick.device_m);
  return std::clamp(kSkin_N_per_m * depth_m, 0.0, 10.0) * normal;
}

}  // namespace telepalp::bench::hand
