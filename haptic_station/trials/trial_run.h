#pragma once

#include <array>
#include <vector>

#include "haptic_station/trials/trial_skin.h"
#include "haptic_station/trials/virtual_station.h"

namespace telepalp::trials {

/// One point of plots like Fig. 5 to 8 of paper S1 (docs/sources.md); a trial has one every 5 ms.
struct TrialSample {
  double time_s;
  control::Phase phase;
  Point<HapticBase> hand;    ///< true position, without tracker noise
  Point<HapticBase> device;  ///< true position
  Point<HapticBase> shown;   ///< position of the displayed hand
  Force<HapticBase> force;
  double indentation_m;
};

struct Transition {
  double time_s;
  control::Phase from;
  control::Phase to;
  control::Event on;
};

/// Measures of a trial's smoothness and safety.
struct TrialFigures {
  std::array<int, control::kPhaseCount> entries{};  ///< number of entries into each phase, at the index phase - 1
  double worst_force_step_N = 0.0;                  ///< largest change of force between two ticks
  double worst_jump_m = 0.0;              ///< largest end-effector motion in a transition's tick, less velocity × tick
  double worst_speed_jump_m_per_s = 0.0;  ///< largest change of the end-effector's velocity in a transition's tick
  double worst_shown_step_m = 0.0;        ///< largest displacement of the displayed hand in one tick
  double most_force_N = 0.0;
  double contact_s = 0.0;
  double unfelt_s = 0.0;           ///< time in which the device was over 2 mm deep in the true skin without a contact
  double least_passivity_J = 0.0;  ///< least PassivityController::balance_J(); negative: the display was active

  [[nodiscard]] int entered(control::Phase phase) const noexcept {
    return entries[static_cast<std::size_t>(phase) - 1];
  }
};

struct TrialResult {
  device::Trial trial = device::Trial::IndentSeveralPoints;
  const char* surface = "";  ///< name of the surface, for the report
  TrialFigures figures;
  std::vector<TrialSample> samples;
  std::vector<Transition> transitions;
};

/// Runs one of S1's trials in virtual time on the station's haptic loop over `skin`.
[[nodiscard]] TrialResult run_trial(device::Trial trial, const VirtualStationSettings& settings, TrialSkin& skin);

/// S1's scene: the skin with the paper's stiffness and the cylinder 0.03 m below it.
[[nodiscard]] VirtualStationSettings paper_settings();

/// The trial's title, for example "first trial: indent several points".
[[nodiscard]] const char* title(device::Trial trial) noexcept;

}  // namespace telepalp::trials
