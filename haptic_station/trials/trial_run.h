#pragma once

#include <array>
#include <vector>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/trials/virtual_station.h"

namespace telepalp::trials {

/// What a figure of S1 plots, taken every 5 ms.
struct TrialSample {
  double time_s;
  control::Phase phase;
  Point<HapticBase> hand;  ///< the true one
  Point<HapticBase> device;
  Point<HapticBase> shown;  ///< the hand as displayed
  Force<HapticBase> force;
  double indentation_m;
};

struct Transition {
  double time_s;
  control::Phase from;
  control::Phase to;
  control::Event on;
};

/// How smooth a trial was.
struct TrialFigures {
  std::array<int, control::kPhaseCount> entries{};
  double worst_force_step_N = 0.0;        ///< from one tick to the next
  double worst_jump_m = 0.0;              ///< of the end-effector at a transition, beyond what its speed explains
  double worst_speed_jump_m_per_s = 0.0;  ///< of the end-effector at a transition, in one tick
  double worst_shown_step_m = 0.0;        ///< of the displayed hand in one tick
  double most_force_N = 0.0;
  double contact_s = 0.0;
  double least_passivity_J = 0.0;

  [[nodiscard]] int entered(control::Phase phase) const noexcept {
    return entries[static_cast<std::size_t>(phase) - 1];
  }
};

struct TrialResult {
  device::Trial trial = device::Trial::IndentSeveralPoints;
  TrialFigures figures;
  std::vector<TrialSample> samples;
  std::vector<Transition> transitions;
};

/// Runs one of S1's trials in virtual time over a level, perhaps breathing, skin.
[[nodiscard]] TrialResult run_trial(device::Trial trial, const VirtualStationSettings& settings,
                                    const device::BreathingPlane& skin);

/// S1's scene: the skin with the stated stiffness and the cylinder 0.03 m under it.
[[nodiscard]] VirtualStationSettings paper_settings();

/// "first trial: indent several points" …
[[nodiscard]] const char* title(device::Trial trial) noexcept;

}  // namespace telepalp::trials
