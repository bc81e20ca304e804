#include "haptic_station/station/parts/viewer_hand_input.h"

#include <chrono>
#include <utility>

namespace telepalp::station {

std::optional<std::string> ViewerHandInput::hear(const msg::ViewerHand& hand, const Point<HapticBase>& at) {
  const auto taken = tracker_->hear(hand, at, std::chrono::steady_clock::now());
  if (std::exchange(taken_, taken) == taken) return std::nullopt;
  return "/viewer/hand: viewer " + std::to_string(hand.viewer()) + ": " + tracking::in_words(taken);
}

core::SurfaceStage::OnImage ViewerHandInput::image_handler() const {
  if (tracker_ == nullptr) return nullptr;
  return [tracker = tracker_](const DepthImage& depth, const Intrinsics& camera,
                              const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
    tracker->see(tracking::heights_of(depth, camera, haptic_from_camera));
  };
}

}  // namespace telepalp::station
