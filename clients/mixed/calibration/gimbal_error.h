#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "clients/mixed/device/device_model.h"

namespace telepalp::mixed {

/// By how much each gimbal encoder reads too little [rad], as a function of its reading: the sum of half a period
/// and a whole period of a sine over the joint's range. Both are zero at the ends of the range, because the maker
/// states the encoder's nonlinearity against the line through its ends. Only joints that move the tip have
/// coefficients: a handle that turns about its own axis keeps its tip.
struct GimbalError {
  static constexpr std::size_t kTermsAJoint = 2;
  std::vector<double> coefficients_rad;  ///< for each gimbal joint: half period, whole period; empty: no error

  [[nodiscard]] double at_rad(const Joint& joint, std::size_t gimbal_joint, double reading_rad) const noexcept;
};

/// The joints' angles: the readings with the gimbal's error added.
[[nodiscard]] std::vector<double> corrected(const DeviceModel& model, const GimbalError& error,
                                            std::span<const double> readings_rad);

}  // namespace telepalp::mixed
