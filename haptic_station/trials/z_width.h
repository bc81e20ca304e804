#pragma once

#include "haptic_station/device/simulated_pair.h"

namespace telepalp::trials {

/// True when the simulated device loses energy over 4 s after a knock against a two-sided virtual wall (a spring that
/// also pulls) of this stiffness. The wall's force is held from one sample to the next, at `rate_hz`. No hand holds the
/// device, so only the device's own damping dissipates energy: the strictest case. `delay_s`: age of the encoders'
/// reading when the force acts, at most 63 samples.
[[nodiscard]] bool wall_is_stable(double stiffness_N_per_m, double rate_hz,
                                  const device::SimulatedDeviceSettings& device, double delay_s = 0.0) noexcept;

/// The upper end of the Z-width: the stiffest stable wall, to 1 %. Theory for a force that is held between samples:
/// stiffness k < 2 b / T, with the device's damping b and the sample period T.
[[nodiscard]] double largest_stable_stiffness_N_per_m(double rate_hz, double damping_N_s_per_m) noexcept;
/// As above, for any device whose force acts `delay_s` late. Theory: k < b / (T / 2 + delay).
[[nodiscard]] double largest_stable_stiffness_N_per_m(double rate_hz, const device::SimulatedDeviceSettings& device,
                                                      double delay_s) noexcept;

}  // namespace telepalp::trials
