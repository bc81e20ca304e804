#pragma once

#include <Eigen/Core>
#include <optional>

#include "haptic_station/loop/device_gate.h"
#include "proto/words/wrench.h"
#include "tools/study/protocol/hands/person_trial.h"

namespace telepalp::study {

/// One penetration by a person whose hand holds the end-effector of a haptic device. The hand is on the handle from the
/// first tick on, wherever the end-effector then is; the axes of the tissue's frame are those of the device. Time runs
/// once the hand has moved by kMoves_m. Pure; a tick neither allocates, locks nor throws. Owner: the haptic thread.
class DevicePenetration {
 public:
  static constexpr double kMoves_m = 0.001;
  /// The force rises from zero in this time after time has begun to run.
  static constexpr double kRise_s = 0.1;
  /// A device that has been silent, or impossibly fast, for this long ends the penetration.
  static constexpr double kSilent_s = 0.05;
  enum class Lost : std::uint8_t { No, Silent, Implausible };

  DevicePenetration(Prepared prepared, Condition condition) noexcept
      : prepared_(std::move(prepared)), feels_(feels(condition)) {}

  /// One tick of kTick_s. `age_s`: since the device last answered. Returns the force on the hand, before the limiter.
  [[nodiscard]] Force<HapticBase> step(const loop::GatedReading& reading, double age_s) noexcept;
  /// `seconds` passed without a tick.
  void held_up(double seconds) noexcept { held_up_s_ += moved_ ? seconds : 0.0; }

  [[nodiscard]] bool over() const noexcept { return prepared_.insertion->over(); }
  [[nodiscard]] bool moved() const noexcept { return moved_; }
  [[nodiscard]] Lost lost() const noexcept { return lost_; }
  [[nodiscard]] TrialView view() const noexcept;
  /// `given`: the force that the limiter let through.
  [[nodiscard]] loop::TickSample tick(const Force<HapticBase>& given) const noexcept;

 private:
  Prepared prepared_;
  bool feels_;
  std::optional<Eigen::Vector3d> shift_m_;  // from the device's frame to the tissue's
  Eigen::Vector3d hand_m_ = Eigen::Vector3d::Zero();
  double share_ = 0.0;  // of the force, while it rises
  double held_up_s_ = 0.0;
  bool moved_ = false;
  Lost lost_ = Lost::No;
};

}  // namespace telepalp::study
