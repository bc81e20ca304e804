#include "clients/mixed/calibration/gimbal_error.h"

#include <cmath>
#include <numbers>

namespace telepalp::mixed {

double GimbalError::at_rad(const Joint& joint, std::size_t gimbal_joint, double reading_rad) const noexcept {
  const std::size_t first = gimbal_joint * kTermsAJoint;
  if (first + kTermsAJoint > coefficients_rad.size()) return 0.0;
  const double turns = (reading_rad - joint.least_rad) / (joint.most_rad - joint.least_rad);
  const double phase = std::numbers::pi * turns;
  return coefficients_rad[first] * std::sin(phase) + coefficients_rad[first + 1] * std::sin(2.0 * phase);
}

std::vector<double> corrected(const DeviceModel& model, const GimbalError& error,
                              std::span<const double> readings_rad) {
  std::vector<double> angles(readings_rad.begin(), readings_rad.end());
  for (std::size_t i = model.gimbal; i < angles.size(); ++i)
    angles[i] += error.at_rad(model.joints[i], i - model.gimbal, readings_rad[i]);
  return angles;
}

}  // namespace telepalp::mixed
