#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "proto/words/time.h"

namespace telepalp::tracking {

/// How long the hand keeps its velocity, learnt from its recent movements: the distance covered in 30 to 80 ms is
/// compared with the velocity at the beginning of these 30 to 80 ms. A hand that pokes and stops keeps its velocity for
/// a short time, and a hand that sweeps for a long time. No allocation.
class VelocityPersistence {
 public:
  /// `expected_s`: the velocity's time constant before any movement was seen. `memory_s`: time over which it is learnt.
  VelocityPersistence(double expected_s, double memory_s) noexcept;

  /// Call before the add() of a state that does not continue the last movement. The learnt time constant is kept.
  void begin_movement() noexcept { count_ = 0; }
  /// Adds the estimated state of the hand at the sample of the time `at`, `dt_s` after the sample before.
  void add(SessionTime at, const Eigen::Vector3d& hand_m, const Eigen::Vector3d& velocity_m_per_s,
           double dt_s) noexcept;

  /// The distance covered in the next `ahead_s`, divided by the present velocity [s].
  [[nodiscard]] double reach_s(double ahead_s) const noexcept;
  /// Share of the present velocity that is left after `ahead_s`, 0 to 1.
  [[nodiscard]] double left(double ahead_s) const noexcept;

 private:
  struct State {
    SessionTime at;
    Eigen::Vector3d hand_m;
    Eigen::Vector3d velocity_m_per_s;
  };
  static constexpr std::size_t kStates = 16;

  [[nodiscard]] const State* a_while_before(SessionTime at) const noexcept;

  double expected_per_s_;
  double memory_s_;
  std::array<State, kStates> states_{};  ///< a ring; the newest is at (next_ - 1)
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  double lost_ = 0.0;    ///< weighted sum of the distances by which a straight-line prediction overshot
  double weight_ = 0.0;  ///< sum of the weights
  double brakes_per_s_;  ///< rate at which the velocity dies away
};

}  // namespace telepalp::tracking
