#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "haptic_station/tracking/protocol/leap_v6.h"

namespace telepalp::tracking {

/// Selects the examining hand among the hands of one tracker frame. Trackers give a hand a new id after losing it for a
/// moment, and sometimes swap the ids of two hands. So position and velocity decide first; the id decides only among
/// the hands near the predicted position. Pure.
class FollowedHand {
 public:
  /// The followed hand in this frame; nullopt: it is missing. `time_s`: the frame's time; any monotonic clock will do.
  [[nodiscard]] std::optional<leap::Hand> choose(double time_s, std::span<const leap::Hand> hands) noexcept;

 private:
  [[nodiscard]] double apart_m(double time_s, const leap::Hand& hand) const noexcept;

  std::optional<leap::Hand> last_;
  double seen_s_ = 0.0;
};

}  // namespace telepalp::tracking
