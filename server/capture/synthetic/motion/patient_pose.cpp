#include "server/capture/synthetic/motion/patient_pose.h"

#include <cmath>

namespace telepalp::capture {

BodyRise body_rise(const PatientPose& pose, double towards_head_m) noexcept {
  constexpr double kHips_m = -0.28;   // the body bends at the hips; negative: towards the feet from the image's middle
  constexpr double kRounded_m = 0.1;  // length over which the bend is rounded
  const double from_hips_m = towards_head_m - kHips_m;
  const double root_m = std::hypot(from_hips_m, kRounded_m);
  const double lever_m = 0.5 * (from_hips_m + root_m);  // 0 at the feet, the distance from the hips at the head
  return {.m = pose.rise_m + pose.tilt * lever_m,
          .per_s = pose.rise_m_per_s + pose.tilt_per_s * lever_m,
          .per_m = pose.tilt * 0.5 * (1.0 + from_hips_m / root_m)};
}

}  // namespace telepalp::capture
