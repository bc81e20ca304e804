#include "server/capture/openni/color_depth_pairing.h"

namespace telepalp::capture {

void ColorDepthPairing::add_color(std::chrono::microseconds driver_time, ColorImage color) {
  color_.emplace(driver_time, std::move(color));
}

void ColorDepthPairing::add_depth(std::chrono::microseconds driver_time, SessionTime arrival, DepthImage depth) {
  depth_ = Pair{driver_time, arrival, std::move(depth), {}};
}

bool ColorDepthPairing::color_within(std::chrono::microseconds reach) const {
  return color_ && std::chrono::abs(color_->first - depth_->driver_time) <= reach;
}

std::optional<ColorDepthPairing::Pair> ColorDepthPairing::take(SessionTime now) {
  if (!depth_) return std::nullopt;
  if (!color_within(kSameInstant) && now - depth_->arrival < kWaitForColor) return std::nullopt;
  Pair pair = std::move(*depth_);
  if (color_ && std::chrono::abs(color_->first - pair.driver_time) <= kStaleColor) pair.color = color_->second;
  depth_.reset();
  return pair;
}

}  // namespace telepalp::capture
