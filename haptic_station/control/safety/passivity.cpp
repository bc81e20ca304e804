#include "haptic_station/control/safety/passivity.h"

#include <algorithm>

namespace telepalp::control {

void PassivityController::begin(double stored_J) noexcept {
  taken_J_ = stored_J_ = stored_J;
  coefficient_N_s_per_m_ = 0.0;
  damping_ = {};
}

Force<HapticBase> PassivityController::step(const Exchange& exchange, double dt_s) noexcept {
  constexpr double kStill_m2_per_s2 = 1e-8;  // 0.1 mm/s: slower than that nothing can be dissipated
  const double damped_J = -damping_.N.dot(exchange.moved.v);
  taken_J_ += exchange.absorbed_J + damped_J;
  dissipated_J_ += damped_J;
  stored_J_ = exchange.stored_J;
  least_J_ = std::min(least_J_, balance_J());

  const double excess_J = -balance_J() - settings_.tolerance_J;
  const double speed2 = exchange.velocity.v.squaredNorm();
  double wanted = 0.0;
  if (settings_.enabled && excess_J > 0.0)
    wanted = std::min(settings_.most_damping_N_s_per_m,
                      excess_J / (std::max(speed2, kStill_m2_per_s2) * settings_.reaction_s));
  const double most_change = settings_.most_damping_N_s_per_m * dt_s / settings_.reaction_s;
  coefficient_N_s_per_m_ += std::clamp(wanted - coefficient_N_s_per_m_, -most_change, most_change);
  damping_.N = -coefficient_N_s_per_m_ * exchange.velocity.v;
  return damping_;
}

}  // namespace telepalp::control
