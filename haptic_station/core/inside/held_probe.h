#pragma once

#include "haptic_station/loop/tick_sample.h"
#include "haptic_station/ultrasound/b_mode.h"
#include "proto/words/frames.h"

namespace telepalp::core {

/// The ultrasound probe that the hand holds.
struct HeldProbe {
  bool on_skin = false;        ///< the probe is pressed on the skin and faces it, so that sound enters the body
  ultrasound::ProbePose pose;  ///< in H; the probe's face is at the proxy, on the skin
};

/// The probe at a tick. Its face looks out of the palm and its long side lies along the hand's x (paper S1 eq. 1,
/// docs/sources.md: the attitude that the tracker's three wrist angles give). While no attitude is known, the probe
/// stands perpendicular to the skin, with its long side along the depth image's rows. A probe whose scan lines are more
/// than 60 degrees off the skin's inward normal is not on the skin. No allocation.
[[nodiscard]] HeldProbe held_probe(const loop::TickSample& tick,
                                   const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept;

}  // namespace telepalp::core
