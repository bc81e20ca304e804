#pragma once

#include "haptic_station/control/values/encountered_settings.h"
#include "proto/words/frames.h"

namespace telepalp::loop {

/// The result of workspace indexing at one tick.
struct Indexed {
  Vector<HapticBase> shift;  ///< position in H, the patient's frame, minus position in the device's own frame [m]
  Vector<HapticBase> moved;  ///< change of `shift` in this tick [m]
  Force<HapticBase> recall;  ///< force towards the touch cylinder; zero inside it
  bool interacts = true;     ///< false: the hand is beyond the touch cylinder, so the body must give no force
};

/// Workspace indexing (paper S2 III.B, docs/sources.md): a small device explores a large body. Inside an upright
/// cylinder about the middle of the device's workspace the hand touches the body. Beyond the cylinder the hand feels a
/// force back to it, proportional to the distance from the cylinder and bounded. Meanwhile the patient moves in the
/// horizontal plane in the direction of this force, at a speed proportional to the force, so that parts of the body
/// beyond the cylinder come into it. The paper states neither a bound nor a hysteresis; here the interaction resumes 2
/// mm inside the cylinder, so that a tremor at the border does not switch the interaction on and off. Owner: haptic
/// thread. Nothing here allocates, locks or throws.
class WorkspaceIndexing {
 public:
  explicit WorkspaceIndexing(const control::IndexingSettings& settings = {}) noexcept : settings_(settings) {}

  /// One tick. `device`: position in the device's own frame. A position that is not finite changes neither `shift`
  /// nor `interacts` and gives no force. `dt_s` is limited to [0, 0.01] s.
  const Indexed& step(const Point<HapticBase>& device, double dt_s) noexcept;

  [[nodiscard]] const Indexed& now() const noexcept { return now_; }

 private:
  static constexpr double kReEntry_m = 0.002;

  control::IndexingSettings settings_;
  Indexed now_;
};

}  // namespace telepalp::loop
