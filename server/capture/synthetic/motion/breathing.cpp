#include "server/capture/synthetic/motion/breathing.h"

#include <cmath>
#include <numbers>

namespace telepalp::capture {

Breath breath_at(SessionTime time, double amplitude_m, double rate_hz) noexcept {
  // Session time counts from 1970. Whole breaths are subtracted first, so that the sine keeps its precision.
  const double breaths = to_seconds(time.time_since_epoch()) * rate_hz;
  const double angle = std::numbers::pi * (breaths - std::floor(breaths));
  const double sine = std::sin(angle);
  return {.lift_m = amplitude_m * sine * sine * sine * sine,
          .speed_m_per_s = amplitude_m * 4.0 * sine * sine * sine * std::cos(angle) * std::numbers::pi * rate_hz};
}

}  // namespace telepalp::capture
