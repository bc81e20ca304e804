#pragma once

#include <Eigen/Core>

namespace telepalp::control {

/// Keeps the force continuous over a transition: the difference between the old phase's force and the new one's fades
/// at a bounded rate. Owner: haptic thread.
class TransitionFade {
 public:
  /// `raw_N`: the force of the current phase. `breaks`: `raw_N` may jump at this tick; the fade then restarts with the
  /// difference between the force last returned and `raw_N`. Returns `raw_N` plus the remaining difference.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& raw_N, bool breaks, double rate_N_per_s,
                                     double dt_s) noexcept;

  /// The part of the last step's force that remains from before the transition [N].
  [[nodiscard]] const Eigen::Vector3d& fading_N() const noexcept { return fading_N_; }

 private:
  Eigen::Vector3d last_N_ = Eigen::Vector3d::Zero();    ///< the force that the last step returned
  Eigen::Vector3d fading_N_ = Eigen::Vector3d::Zero();  ///< the part that still fades
};

}  // namespace telepalp::control
