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
  double surface_speed_m_per_s = 0.0;  ///< of the surface along the normal, positive away from the body
  double age_s = 0.0;                  ///< now less the capture time of the surface
};

}  // namespace telepalp::ports
