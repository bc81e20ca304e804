#pragma once

#include <Eigen/Core>

#include "tools/study/person/operator.h"

namespace telepalp::study {

/// An arm in the plane of the tool: a mass on a spring and a damper to its far end, which the person moves. Pure.
class Arm {
 public:
  Arm(const Operator& person, const Eigen::Vector3d& at_m) noexcept : person_(person), hand_m_(at_m), end_m_(at_m) {}
  /// One tick of kTick_s: the far end moves to `end_m`, and `force_N` acts on the hand.
  void step(const Eigen::Vector3d& end_m, const Eigen::Vector3d& force_N) noexcept;
  [[nodiscard]] const Eigen::Vector3d& hand_m() const noexcept { return hand_m_; }

 private:
  Operator person_;
  Eigen::Vector3d hand_m_;
  Eigen::Vector3d end_m_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
};

}  // namespace telepalp::study
