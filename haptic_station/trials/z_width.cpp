#include "haptic_station/trials/z_width.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace telepalp::trials {

bool wall_is_stable(double stiffness_N_per_m, double rate_hz, const device::SimulatedDeviceSettings& device,
                    double delay_s) noexcept {
  constexpr int kInner = 20;  // integration steps of the device between two samples
  constexpr double kLasts_s = 4.0;
  const double sample_s = 1.0 / rate_hz;
  const double b_over_m = device.damping_N_s_per_m / device.mass_kg;
  double x_m = 0.0;
  double v = -0.05;
  double early_J = 0.0;
  double late_J = 0.0;
  const int samples = static_cast<int>(kLasts_s * rate_hz);
  std::array<double, 64> seen_m{};
  const auto late = std::min(static_cast<std::size_t>(std::lround(delay_s * rate_hz)), seen_m.size() - 1);
  for (int i = 0; i < samples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    seen_m[at % seen_m.size()] = std::round(x_m / device.encoder_step_m) * device.encoder_step_m;
    // A two-sided wall is the hardest to stabilise.
    const double force_N = -stiffness_N_per_m * seen_m[(at + seen_m.size() - late) % seen_m.size()];
    for (int k = 0; k < kInner; ++k) {  // exact for a constant force over the inner step
      const double h = sample_s / kInner;
      const double decay = std::exp(-b_over_m * h);
      const double final_speed = force_N / device.damping_N_s_per_m;
      x_m += final_speed * h + (v - final_speed) * (1.0 - decay) / b_over_m;
      v = final_speed + (v - final_speed) * decay;
    }
    const double energy_J = 0.5 * device.mass_kg * v * v + 0.5 * stiffness_N_per_m * x_m * x_m;
    if (!(energy_J < 1e6)) return false;
    (2 * i < samples ? early_J : late_J) += energy_J;
  }
  return late_J < early_J;
}

double largest_stable_stiffness_N_per_m(double rate_hz, double damping_N_s_per_m) noexcept {
  device::SimulatedDeviceSettings device;
  device.damping_N_s_per_m = damping_N_s_per_m;
  return largest_stable_stiffness_N_per_m(rate_hz, device, 0.0);
}

double largest_stable_stiffness_N_per_m(double rate_hz, const device::SimulatedDeviceSettings& device,
                                        double delay_s) noexcept {
  double stable = 1.0;
  double unstable = 1e7;
  while (unstable / stable > 1.01) {
    const double middle = std::sqrt(stable * unstable);
    (wall_is_stable(middle, rate_hz, device, delay_s) ? stable : unstable) = middle;
  }
  return stable;
}

}  // namespace telepalp::trials
