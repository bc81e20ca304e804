#pragma once

#include "haptic_station/device/simulated_pair.h"

namespace telepalp::trials {

/// True when the simulated device loses energy over 4 s after a knock against a two-sided virtual wall (a spring that
/// also pulls) of this stiffness. The wall's force is held between samples. No hand holds the device, so only the
/// device's own damping dissipates energy: the strictest case.
[[nodiscard]] bool wall_is_stable(double stiffness_N_per_m, double rate_hz,
                                  const device::SimulatedDeviceSettings& device) noexcept;

/// The upper end of the Z-width: the stiffest stable wall, to 1 %. Theory for a force that is held between samples: k <
/// 2 b / T, with damping b and sample period T.
[[nodiscard]] double largest_stable_stiffness_N_per_m(double rate_hz, double damping_N_s_per_m) noexcept;

}  // namespace telepalp::trials
