#pragma once

#include <optional>
#include <span>

#include "clients/mixed/view/view.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::mixed {

/// Where the device and the tool are at one tick of the station: the coupling's two ends.
struct CouplingEnds {
  SessionTime at;
  Point<HapticBase> device;
  Point<HapticBase> tool;  ///< the proxy, to which the virtual tool is drawn
};

/// The ends at the time of a camera's image, interpolated linearly between two states. An image up to `patience` after
/// the last state gets that state. nullopt for an image before the first state, or without a state within `patience`.
/// `states`: by increasing time.
[[nodiscard]] std::optional<CouplingEnds> ends_at(std::span<const CouplingEnds> states, SessionTime image,
                                                  std::chrono::nanoseconds patience);

/// By how much the hand's image is moved so that it meets the tool [px]: the image of the tool minus the image of the
/// device point. The image of a displacement depends on where it starts; paper S3 (docs/sources.md) 7 projects the
/// vector alone.
/// nullopt if one of the points is behind the camera.
[[nodiscard]] std::optional<Eigen::Vector2d> hand_shift_px(const View& view, const Point<World>& device,
                                                           const Point<World>& tool) noexcept;

}  // namespace telepalp::mixed
