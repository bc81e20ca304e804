#pragma once

#include "proto/words/time.h"

namespace telepalp::capture {

/// Displacement of the belly by breathing.
struct Breath {
  double lift_m = 0.0;         ///< rise of the belly above full exhale
  double speed_m_per_s = 0.0;  ///< rate of change of lift_m
};

/// The breath at `time`: lift = A sin^4(pi f t) with A = `amplitude_m` and f = `rate_hz`, exactly periodic, with full
/// exhale at time 0. The belly stays near full exhale longer than near full inhale. Source: Lujan et al. 1999,
/// A cos^2n(pi t / tau) with n = 2, shifted to begin at full exhale.
[[nodiscard]] Breath breath_at(SessionTime time, double amplitude_m, double rate_hz) noexcept;

}  // namespace telepalp::capture
