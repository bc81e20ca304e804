#pragma once

#include "haptic_station/device/simulated_pair.h"

namespace telepalp::trials {

/// Whether the simulated device at a virtual wall of this stiffness, its force held between samples, comes to rest when
/// it is knocked and nothing but its own damping holds it: the strictest case, without a hand.
[[nodiscard]] bool wall_is_stable(double stiffness_N_per_m, double rate_hz,
                                  const device::SimulatedDeviceSettings& device) noexcept;

/// Z-width: the stiffest such wall, to 1 %. Theory for a held force: k < 2 b / T at most.
[[nodiscard]] double largest_stable_stiffness_N_per_m(double rate_hz, double damping_N_s_per_m) noexcept;

}  // namespace telepalp::trials
