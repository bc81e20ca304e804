#include "tests/bench/link/camera_feed.h"

#include <algorithm>

namespace telepalp::bench::link {

using namespace std::chrono_literals;

CameraFeed::CameraFeed(const Scenario& scenario) : scenario_(scenario), random_(scenario.seed + 1000) {}

std::vector<std::byte> CameraFeed::content(double mean_B) {
  const double share = static_cast<double>(random_() >> 11U) * 0x1.0p-53;
  std::vector<std::byte> bytes(static_cast<std::size_t>(mean_B * (0.9 + 0.2 * share)));
  for (std::size_t i = 0; i < bytes.size(); i += 64) bytes[i] = static_cast<std::byte>(random_());
  outcome_.content_B += static_cast<double>(bytes.size());
  return bytes;
}

std::vector<CameraImage> CameraFeed::due(Nanoseconds now) {
  std::vector<CameraImage> images;
  for (;;) {
    const Nanoseconds captured = from_seconds(next_ / scenario_.frames_hz);
    if (captured + scenario_.encoding > now || to_seconds(captured) >= scenario_.seconds) return images;
    images.push_back({kDepth, next_, captured, content(scenario_.depth_B)});
    images.push_back({kColour, next_, captured, content(scenario_.colour_B)});
    for (const CameraImage& image : {images[images.size() - 2], images.back()})
      sizes_[{image.image, next_}] = image.bytes.size();
    ++outcome_.frames;
    ++next_;
  }
}

void CameraFeed::complete(Image image, std::uint32_t number, Nanoseconds captured, std::size_t bytes, Nanoseconds now) {
  const auto sent = sizes_.find({image, number});
  if (sent == sizes_.end() || sent->second != bytes || captured != from_seconds(number / scenario_.frames_hz)) {
    ++outcome_.wrong;
    return;
  }
  outcome_.latency_ms.add(to_milliseconds(now - captured - scenario_.encoding));
  if (image == kDepth) newest_depth_ = std::max(newest_depth_, captured);
  if (now - captured <= scenario_.deadline && ++images_in_time_[number] == 2) ++outcome_.in_time;
}

void CameraFeed::sample_age(Nanoseconds now) {
  if (newest_depth_ >= 0ns && to_seconds(now) < scenario_.seconds)
    outcome_.depth_age_ms.add(to_milliseconds(now - newest_depth_));
}

bool CameraFeed::finished(Nanoseconds now) const noexcept { return to_seconds(now) >= scenario_.seconds + 2.0; }

Scenario over(Nanoseconds round_trip, double loss, double burst_packets) {
  const impaired::Impairment either{.delay = round_trip / 2, .loss = loss, .burst_packets = burst_packets};
  return {.down = either, .up = either};
}

}  // namespace telepalp::bench::link
