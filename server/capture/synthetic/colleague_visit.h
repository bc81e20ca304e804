#pragma once

#include <optional>

#include "server/capture/synthetic/shape/colleague_hand.h"
#include "server/capture/synthetic/true_surface.h"

namespace telepalp::capture {

/// A colleague's hand, with its forearm to the image's edge, that comes to the patient, stays and leaves. Its fingers
/// move.
struct ColleagueVisit {
  Point<DepthCamera> place;  ///< the palm stays over the skin on the ray through this point
  double over_m = 0.0;       ///< height of the palm's underside over the skin; 0: it lies on the skin and moves with it
  double heading_rad = 0.0;  ///< as in ColleagueHand
  double arm_rise_rad = 0.3;  ///< as in ColleagueHand
  bool from_above = false;    ///< comes down from 0.3 m higher; false: comes from the side
  double begins_s = 0.0;      ///< time at which the hand is just outside the image
  double stays_s = 10.0;
  double fingers_hz = 1.3;  ///< rate at which the fingers move

  /// The hand at `time_s`; nullopt: it is not in the picture. `rest`: the skin at rest, over which a hand hovers;
  /// `now`: the skin at this time, on which it lies.
  [[nodiscard]] std::optional<ColleagueHand> at(double time_s, const TrueSurface& rest, const TrueSurface& now) const;
  /// The time at which the hand begins to leave.
  [[nodiscard]] double leaves_s() const noexcept { return 0.5 * (begins_s + gone_s() + stays_s); }
  /// From this time on, no image shows the hand.
  [[nodiscard]] double gone_s() const noexcept;

  static constexpr double kSpeed_m_per_s = 0.3;
};

}  // namespace telepalp::capture
