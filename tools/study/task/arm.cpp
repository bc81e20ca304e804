#include "tools/study/task/arm.h"

#include <cmath>

#include "tools/study/task/insertion.h"

namespace telepalp::study {

using Eigen::Vector3d;

void Arm::step(const Vector3d& end_m, const Vector3d& force_N) noexcept {
  const double damping = 2.0 * person_.arm_damping * std::sqrt(person_.arm_N_per_m * person_.arm_kg);
  const Vector3d end_velocity = (end_m - end_m_) / kTick_s;
  end_m_ = end_m;
  const Vector3d push_N = person_.arm_N_per_m * (end_m_ - hand_m_) + damping * (end_velocity - velocity_);
  velocity_ += kTick_s / person_.arm_kg * (push_N + force_N);
  hand_m_ += kTick_s * velocity_;
}

}  // namespace telepalp::study
