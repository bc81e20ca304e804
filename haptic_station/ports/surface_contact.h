#pragma once

#include "proto/words/frames.h"

namespace telepalp::ports {

/// The surface's answer for the device point at one tick. The loop fills it from `surface::Touch`; the controller and
/// the effects know the surface through this value alone.
struct SurfaceContact {
  Point<HapticBase> proxy;             ///< the device point held on the surface
  Vector<HapticBase> normal;           ///< unit, away from the body, at the proxy
  double distance_m = 0.0;             ///< signed, of the device point; negative inside the body
  bool in_body = false;                ///< S1's i_b
  bool valid = false;                  ///< false: no surface near the device point; only age_s has a meaning then
  double surface_speed_m_per_s = 0.0;  ///< of the surface along the normal, positive away from the body; continuous
  double support = 1.0;           ///< 1 well inside known surface, 0 where it ends or is stale; `proxy` has faded by it
  double measured_above_m = 0.0;  ///< of the newest measured surface, carried to now, over the displayed one
  double measured_speed_m_per_s = 0.0;   ///< of that measured surface along the normal
  bool anchor_seen = false;              ///< false: the whole surface moves as it does at the proxy
  Vector<HapticBase> anchor_velocity{};  ///< of the displayed surface where the contact began [m/s]
  double age_s = 0.0;                    ///< now less the capture time of the surface
};

}  // namespace telepalp::ports
