#pragma once

#include <array>
#include <vector>

#include "clients/mixed/background/background.h"
#include "clients/mixed/scene/desk_scene.h"

namespace telepalp::mixed {

/// An Omni on the desk, which faces the doctor.
[[nodiscard]] StandingDevice desk_device(const std::vector<double>& joints_rad);

/// A hand around the handle of `device`, moved by `shift_m`. The arm comes from the doctor's right.
[[nodiscard]] HoldingHand holding_hand(const StandingDevice& device, const Eigen::Vector3d& shift_m,
                                       const std::array<std::uint8_t, 3>& color = {205, 150, 120});

/// The approximate surface that stands for the background.
enum class ProxyKind {
  Planes,  ///< desk_planes()
  Depth,   ///< desk_depths()
};

/// Planes of desk, walls and floor, as a person would measure them: without the things on the desk.
[[nodiscard]] Proxy desk_planes();

/// The planes, and the meshes of a depth camera's images from three places, which show the things on the desk.
/// `printed_pages`: the desk has printed pages on it. `threads`: renders on so many threads.
[[nodiscard]] Proxy desk_depths(bool printed_pages, int threads);

}  // namespace telepalp::mixed
