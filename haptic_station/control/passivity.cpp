#include "haptic_station/control/passivity.h"

#include <algorithm>

namespace telepalp::control {

void PassivityController::begin(double stored_J) noexcept { taken_J_ = stored_J_ = stored_J; }

Force<HapticBase> PassivityController::step(double absorbed_W, double stored_J, const Vector<HapticBase>& velocity,
                                            double dt_s) noexcept {
  constexpr double kStill_m2_per_s2 = 1e-8;  // 0.1 mm/s: slower than that nothing can be dissipated
  taken_J_ += absorbed_W * dt_s;
  stored_J_ = stored_J;
  const double excess_J = stored_J_ - taken_J_ - settings_.tolerance_J;
  const double speed2 = velocity.v.squaredNorm();
  Force<HapticBase> damping;
  if (settings_.enabled && excess_J > 0.0 && speed2 > kStill_m2_per_s2 && dt_s > 0.0) {
    const double enough = excess_J / (speed2 * dt_s);
    const double chosen = std::min(enough, settings_.most_damping_N_s_per_m);
    damping.N = -chosen * velocity.v;
    taken_J_ += chosen * speed2 * dt_s;
    dissipated_J_ += chosen * speed2 * dt_s;
  }
  least_J_ = std::min(least_J_, balance_J());
  return damping;
}

}  // namespace telepalp::control
