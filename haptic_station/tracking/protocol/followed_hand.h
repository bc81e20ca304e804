#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "haptic_station/tracking/protocol/leap_v6.h"

namespace telepalp::tracking {

struct FollowedHandSettings {
  double same_within_m = 0.06;  ///< a new id so near to where the followed hand must be is the same hand
  double other_after_s = 0.3;   ///< without the followed hand before another one is followed
};

/// Which hand of a frame is the examining one. Trackers give a hand a new id when they lose it for a moment, and
/// sometimes swap the ids of two hands: place and speed decide, the id only among hands that could be it. Pure.
class FollowedHand {
 public:
  explicit FollowedHand(const FollowedHandSettings& settings = {}) noexcept : settings_(settings) {}

  /// The followed hand in this frame; nullopt: it is not there. `time_s`: of the frame, on any clock that only rises.
  [[nodiscard]] std::optional<leap::Hand> choose(double time_s, std::span<const leap::Hand> hands) noexcept;

 private:
  [[nodiscard]] double apart_m(double time_s, const leap::Hand& hand) const noexcept;

  FollowedHandSettings settings_;
  std::optional<leap::Hand> last_;
  double seen_s_ = 0.0;
};

}  // namespace telepalp::tracking
