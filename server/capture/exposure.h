#pragma once

#include <string>

namespace telepalp::capture {

/// How a camera exposes its colour images.
struct Exposure {
  bool automatic = true;  ///< the camera chooses both values below
  double exposure = 0.0;  ///< in ExposureLimits::unit
  double gain = 1.0;      ///< in the unit of the camera's driver; of the synthetic patient: a factor
  bool operator==(const Exposure&) const = default;
};

/// What may be set.
struct ExposureLimits {
  std::string unit{};  ///< of the exposure
  double least = 0.0;
  double most = 0.0;
  double least_gain = 0.0;
  double most_gain = 0.0;
};

}  // namespace telepalp::capture
