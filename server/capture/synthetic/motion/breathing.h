#pragma once

#include "proto/words/time.h"

namespace telepalp::server {

/// Where in a breath the patient is.
struct Breath {
  double lift_m = 0.0;         ///< rise of the belly above full exhale
  double speed_m_per_s = 0.0;  ///< its rate of change
};

/// The breath at `time`: lift = A sin^4(pi f t), exactly periodic, at full exhale at time 0 and resting there longer
/// than at full inhale. Source: Lujan et al. 1999, A cos^2n(pi t / tau) with n = 2, shifted to begin at exhale.
[[nodiscard]] Breath breath_at(SessionTime time, double amplitude_m, double rate_hz) noexcept;

}  // namespace telepalp::server
