#pragma once

#include <span>

#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::device {

/// The part of the scene's state that the simulated person knows.
struct TrialView {
  double time_s = 0.0;            ///< time since the trial's start
  ports::SurfaceContact contact;  ///< contact of the end-effector with the skin
  Point<HapticBase> device;
};

/// One leg of a trial: the hand moves smoothly from the end of the last leg to this point. Heights are above the
/// undeformed skin; negative heights press into it.
struct Waypoint {
  double seconds;  ///< duration of the leg
  double x_m;      ///< relative to the trial's centre
  double height_m;
  double z_m;
};

/// The four trials of paper S1 (docs/sources.md) III.A, the insertion of a needle, and the comparison of two objects.
enum class Trial {
  IndentSeveralPoints,  ///< 1: indent the skin at different points
  MoveWithin,           ///< 2: enter at one point and move within the body
  FindCylinder,         ///< 3: touch the upper and lateral area of a cylinder inside the body
  FreeSearch,           ///< 4: search for the cylinder, entering at several points
  InsertNeedle,         ///< go straight in, rest, withdraw, go in again through the same hole, then beside it
  PushSideways,         ///< between two objects: push one to the left and the other one to the right, twice
};
[[nodiscard]] std::span<const Waypoint> waypoints(Trial trial) noexcept;
[[nodiscard]] double duration_s(Trial trial) noexcept;

/// A simulated person who repeats a trial. The person estimates the skin's height from the contact of the end-effector
/// with a slow filter, so that breathing does not move the intended position. Pure. Owner: haptic thread.
class ScriptedIntention {
 public:
  /// `center`: the point on the skin at which the trial's x and z are zero.
  ScriptedIntention(std::span<const Waypoint> script, const Point<HapticBase>& center) noexcept
      : script_(script), center_(center), skin_height_m_(center.m.y()) {}

  [[nodiscard]] Intention step(const TrialView& view, double dt_s) noexcept;

 private:
  std::span<const Waypoint> script_;
  Point<HapticBase> center_;
  double skin_height_m_;
};

}  // namespace telepalp::device
