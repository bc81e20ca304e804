#pragma once

#include <span>

#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::device {

/// What the simulated person sees of the scene.
struct TrialView {
  double time_s = 0.0;            ///< since the trial's start
  ports::SurfaceContact contact;  ///< of the end-effector
  Point<HapticBase> device;
};

/// One leg of a trial: the hand goes, smoothly, from where the last leg ended. Heights are above the undeformed skin;
/// negative ones press into it.
struct Waypoint {
  double seconds;  ///< to get there
  double x_m;      ///< from the trial's centre
  double height_m;
  double z_m;
};

/// The four trials of S1 III.A.
enum class Trial {
  IndentSeveralPoints,  ///< 1: indent the skin at different points
  MoveWithin,           ///< 2: enter at one point and move within the body
  FindCylinder,         ///< 3: touch the cylinder's upper and lateral area
  FreeSearch,           ///< 4: look for it, from several entries
};
[[nodiscard]] std::span<const Waypoint> waypoints(Trial trial) noexcept;
[[nodiscard]] double duration_s(Trial trial) noexcept;

/// A person who carries out a trial again and again. Knows the skin's height from what the end-effector meets, slowly
/// as a person does: the skin's breathing does not move the intention. Pure. Owner: control thread.
class ScriptedIntention {
 public:
  /// `center`: the point on the skin that the trial's x and z count from.
  ScriptedIntention(std::span<const Waypoint> script, const Point<HapticBase>& center) noexcept
      : script_(script), center_(center), skin_height_m_(center.m.y()) {}

  [[nodiscard]] Intention step(const TrialView& view, double dt_s) noexcept;

 private:
  std::span<const Waypoint> script_;
  Point<HapticBase> center_;
  double skin_height_m_;
};

}  // namespace telepalp::device
