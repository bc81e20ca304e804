#pragma once

#include <optional>
#include <string>

#include "haptic_station/core/surface_stage.h"
#include "haptic_station/tracking/protocol/viewer_hand_tracker.h"

namespace telepalp::station {

/// The hand that is held in a viewer, on its way to the tracker that the haptic thread samples. Owner: network thread.
class ViewerHandInput {
 public:
  /// `tracker`: of the station's rig, which outlives this object; nullptr: the hand is not held in a viewer.
  explicit ViewerHandInput(tracking::ViewerHandTracker* tracker) noexcept : tracker_(tracker) {}

  [[nodiscard]] bool is_used() const noexcept { return tracker_ != nullptr; }
  /// Hands on a viewer's message. `at`: its hand in H. Returns the line for the log when the outcome has changed.
  [[nodiscard]] std::optional<std::string> hear(const msg::ViewerHand& hand, const Point<HapticBase>& at);
  /// Takes the images over which the hand flies, on the surface thread; empty: no tracker needs them.
  [[nodiscard]] core::SurfaceStage::OnImage image_handler() const;

 private:
  tracking::ViewerHandTracker* tracker_;  // hear() on the network thread, see() on the surface thread
  std::optional<tracking::ViewerHandTracker::Taken> taken_;  // last logged outcome
};

}  // namespace telepalp::station
