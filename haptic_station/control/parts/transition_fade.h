#pragma once

#include <Eigen/Core>

namespace telepalp::control {

/// Keeps the force continuous over a transition: what the old phase gave beyond the new one fades at a bounded rate.
/// Owner: control thread.
class TransitionFade {
 public:
  /// `raw_N`: the force that the phase gives. `breaks`: the force may jump at this tick, so the difference from the
  /// last tick's force begins to fade now. Returns the force that is left to pass to the limiter.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& raw_N, bool breaks, double rate_N_per_s,
                                     double dt_s) noexcept;

  /// The part of the last step's force that is left from before the break [N].
  [[nodiscard]] const Eigen::Vector3d& fading_N() const noexcept { return fading_N_; }

 private:
  Eigen::Vector3d last_N_ = Eigen::Vector3d::Zero();    ///< what the last step returned
  Eigen::Vector3d fading_N_ = Eigen::Vector3d::Zero();  ///< the rest of the force from before the last break
};

}  // namespace telepalp::control
