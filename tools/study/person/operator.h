#pragma once

#include <array>
#include <string_view>

#include "tools/study/person/parameter.h"

namespace telepalp::study {

/// What an operator perceives. S4's subjects had Both; S4 asks whether force helps; Force and Vision are the controls.
enum class Condition {
  Force,       ///< feels the needle's force; sees nothing
  Vision,      ///< sees the needle outside the skin; feels nothing
  Both,        ///< as in S4: feels the force, and sees the outer skin alone
  NoReflexes,  ///< as Both, but goes on for 0.2 s after the puncture and then stops, whatever the senses say
  Neither,     ///< only for the check: knows the depth from a picture, and moves by the sense of the own hand
  SeesLayers,  ///< only for the check: no force, but sees the inner layers and the needle that passes them
};
inline constexpr std::array kStudied{Condition::Force, Condition::Vision, Condition::Both, Condition::NoReflexes};
[[nodiscard]] constexpr std::string_view name(Condition condition) noexcept {
  constexpr std::string_view kNames[] = {"force", "vision", "both", "no-reflexes", "neither", "sees-layers"};
  return kNames[static_cast<std::size_t>(condition)];
}
[[nodiscard]] constexpr bool feels(Condition condition) noexcept {
  return condition == Condition::Force || condition == Condition::Both || condition == Condition::NoReflexes;
}
[[nodiscard]] constexpr bool sees_needle(Condition condition) noexcept {
  return condition != Condition::Force && condition != Condition::Neither;
}

/// A simulated operator: an arm that is a mass on a spring and a damper, whose far end the operator moves.
struct Operator {
  double reaction_s = 0.2;
  double arm_N_per_m = 300.0;
  double arm_damping = 0.5;  ///< damping ratio of the arm
  double arm_kg = 0.5;
  double tremor_m = 1e-4;        ///< RMS of the far end, along each axis
  double hand_m_per_s = 0.04;    ///< speed of the hand far from where a puncture is expected
  double patience_s = 2.0;       ///< time spent on the depths at which the puncture may come: expected +- 2 SD
  double force_jnd = 0.12;       ///< smallest change of force that is noticed, as a share of the force
  double force_floor_N = 0.05;   ///< smallest change of force that is noticed at small forces
  double kinaesthesia = 0.1;     ///< standard deviation of the sense of depth without sight, as a share of the depth
  double needle_sight = 0.06;    ///< as kinaesthesia, while the needle outside the skin is seen
  double layer_sight_m = 0.001;  ///< SD of the sense of depth while the inner layers are seen
  double caution = 1.5;  ///< standard deviations past the expected puncture at which the operator stops without a cue
};

/// Ranges of all operators, with their sources.
[[nodiscard]] std::span<const Drawn<Operator>> operator_ranges() noexcept;

/// What an operator can perceive at one tick of a penetration.
struct Perceived {
  double depth_m = 0.0;       ///< depth of the tip below the skin
  double hand_force_N = 0.0;  ///< force of the needle on the hand
  bool layer_passed = false;  ///< the needle has passed the layer: seen only with Condition::SeesLayers
  bool punctured = false;     ///< the sac is punctured: what NoReflexes waits for, and what S4's program tells
};

/// What the operator has learned about the depth at which the layer gives way. S4's program reports the overshoot after
/// each penetration, so the operator learns from each one.
struct Learned {
  double depth_m = 0.0;
  int from = 0;  ///< number of penetrations in the mean `depth_m`
  void add(double seen_m) noexcept { depth_m += (seen_m - depth_m) / ++from; }
};

/// Moves the far end of the arm in one penetration. Pure: all random numbers come from `random`.
class Decisions {
 public:
  Decisions(const Operator& person, Condition condition, const Learned& learned, device::Random& random) noexcept;

  /// Speed of the arm's far end along the path of the hand [m/s].
  [[nodiscard]] double speed_m_per_s(const Perceived& sensed, double dt_s) noexcept;
  /// Where the operator believes the tip to be, with this penetration's error [m below the skin].
  [[nodiscard]] double sensed_depth_m(double depth_m) const noexcept { return depth_m * (1.0 + error_); }
  /// The arm's far end stands still.
  [[nodiscard]] bool stopped() const noexcept { return speed_ == 0.0; }
  /// Offset of the far end by tremor at `time_s` [m].
  [[nodiscard]] double tremor_m(double time_s, int axis) const noexcept;
  [[nodiscard]] bool noticed() const noexcept { return noticed_; }  ///< the puncture, by force or by sight

 private:
  void sense(const Perceived& sensed, double dt_s) noexcept;
  [[nodiscard]] double wanted_speed(double depth_m) const noexcept;

  const Operator& person_;
  Condition condition_;
  double expected_m_;
  double uncertain_m_;  // standard deviation of the sense of depth where the puncture is expected
  double error_ = 0.0;  // of the sense of depth in this penetration, as a share
  double reaction_s_;
  double stop_at_m_;
  std::array<std::array<double, 4>, 2> phases_{};
  double tremor_Hz_;
  double felt_N_ = 0.0;  // force on the hand, smoothed over 20 ms
  double peak_N_ = 0.0;
  double decided_s_ = -1.0;  // time since a cue; negative: no cue
  double paused_s_ = 0.0;
  double speed_ = 0.0;
  bool noticed_ = false;
};

}  // namespace telepalp::study
