#pragma once

#include "proto/words/frames.h"

namespace telepalp::effects {

/// What the surface says of the device point at one tick. The loop fills it from the surface's answer; the
/// controller knows the surface only through it.
struct SurfaceContact {
  Point<HapticBase> proxy;             ///< the device point held on the surface
  Vector<HapticBase> normal;           ///< unit, away from the body, at the proxy
  double distance_m = 0.0;             ///< signed, of the device point; negative inside the body
  bool in_body = false;                ///< S1's i_b
  bool valid = false;                  ///< false: no surface near the device point; the rest is then meaningless
  double surface_speed_m_per_s = 0.0;  ///< of the surface along the normal, positive away from the body
  double age_s = 0.0;                  ///< now less the capture time of the surface
};

}  // namespace telepalp::effects
