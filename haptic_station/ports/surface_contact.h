#pragma once

#include "proto/words/frames.h"

namespace telepalp::ports {

/// The contact of the device point with the surface at one tick. The haptic loop fills it from `surface::Touch`. The
/// controller and the effects learn of the surface only through this value. The displayed surface is the one that the
/// hand feels. It follows the newest measured surface, predicted to now, with a lag: when a newer surface arrives, it
/// changes gradually.
struct SurfaceContact {
  Point<HapticBase> proxy;    ///< outside the body: the device point; in the body: see `coverage`
  Vector<HapticBase> normal;  ///< unit normal of the surface at the proxy, out of the body
  double distance_m = 0.0;    ///< signed distance of the device point from the surface; negative inside the body
  bool in_body = false;       ///< the device point is in the body; i_b of paper S1 (docs/sources.md)
  bool valid = false;         ///< false: no surface near the device point, and only age_s has a meaning
  double surface_speed_m_per_s = 0.0;  ///< of the displayed surface along the normal; continuous
  /// 1 well inside the known surface, 0 where it ends or is stale. In the body, `proxy` lies this share of the way from
  /// the device point to the surface point nearest to it: on the surface if 1, at the device if 0.
  double coverage = 1.0;
  double measured_above_m = 0.0;         ///< height of the newest measured surface over the displayed one
  double measured_speed_m_per_s = 0.0;   ///< speed of the measured surface along the normal
  bool anchor_seen = false;              ///< false: anchor_velocity is unknown; use the speed at the proxy instead
  Vector<HapticBase> anchor_velocity{};  ///< velocity of the displayed surface where the contact began [m/s]
  double age_s = 0.0;                    ///< time since the surface's capture, or since its adoption if that is longer
};

}  // namespace telepalp::ports
