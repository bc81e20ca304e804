#pragma once

#include <Eigen/Core>
#include <optional>

#include "server/capture/synthetic/motion/breathing.h"
#include "server/capture/synthetic/motion/colleague_pose.h"

namespace telepalp::capture {

/// Pose of the patient at one instant, with its rate of change. All zero: at rest at full exhale.
struct PatientPose {
  Breath breath;
  Eigen::Vector2d slide_m = Eigen::Vector2d::Zero();  ///< in the image plane: x to the head, y to the patient's left
  Eigen::Vector2d slide_m_per_s = Eigen::Vector2d::Zero();
  double rise_m = 0.0;  ///< displacement of the whole body towards the camera
  double rise_m_per_s = 0.0;
  double tilt = 0.0;  ///< of a patient who sits up: metres of rise per metre from the hips to the head
  double tilt_per_s = 0.0;
  std::optional<ColleagueHand> colleague = {};  ///< another person's hand in the picture; no part of the true surface

  [[nodiscard]] bool slides() const noexcept { return !slide_m.isZero(); }
  [[nodiscard]] bool rises() const noexcept { return rise_m != 0.0 || tilt != 0.0; }
};

/// Displacement of a point of the body towards the camera without breathing [m], its rate of change [m/s], and its
/// slope along the body towards the head [m/m].
struct BodyRise {
  double m = 0.0;
  double per_s = 0.0;
  double per_m = 0.0;
};
/// The displacement of the body's point that lies `towards_head_m` metres from the image's middle towards the head.
[[nodiscard]] BodyRise body_rise(const PatientPose& pose, double towards_head_m) noexcept;

}  // namespace telepalp::capture
