#include "clients/mixed/scene/desk_props.h"

namespace telepalp::mixed {

using Eigen::Vector3d;

StandingDevice desk_device(const std::vector<double>& joints_rad) {
  StandingDevice device{omni(), joints_rad, {}};
  // The base's z points to the doctor, who sits at negative y.
  device.world_from_haptic.iso.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  device.world_from_haptic.iso.translation() = Vector3d(0.0, 0.22, 0.0);
  return device;
}

HoldingHand holding_hand(const StandingDevice& device, const Vector3d& shift_m,
                         const std::array<std::uint8_t, 3>& color) {
  const auto [from, to] = device.handle();
  return {.grip = {Vector3d(0.65 * from.m + 0.35 * to.m + shift_m)},
          .handle = {Vector3d((to.m - from.m).normalized())},
          .arm = {Vector3d(Vector3d(0.35, -0.9, -0.12).normalized())},
          .color = color};
}

Proxy desk_planes() {
  Proxy proxy = plane_proxy({-0.9, -0.6, 0.0}, {1.8, 0, 0}, {0, 1.4, 0}, 24, 18);       // desk
  append(proxy, plane_proxy({-1.08, 0.8, -0.7}, {2.46, 0, 0}, {0, 0, 2.2}, 16, 14));    // back wall
  append(proxy, plane_proxy({-1.08, -0.85, -0.7}, {0, 1.65, 0}, {0, 0, 2.2}, 10, 14));  // left wall
  append(proxy, plane_proxy({1.38, -0.85, -0.7}, {0, 1.65, 0}, {0, 0, 2.2}, 10, 14));   // right wall
  append(proxy, plane_proxy({-3.0, -1.5, -0.71}, {6.0, 0, 0}, {0, 2.3, 0}, 16, 8));     // floor
  return proxy;
}

Proxy desk_depths(bool printed_pages, int threads) {
  Proxy proxy = desk_planes();
  const Intrinsics lens{320, 240, 260, 260, 159.5, 119.5};
  for (const Vector3d& eye : {Vector3d(0, -0.5, 0.7), Vector3d(-0.45, -0.35, 0.6), Vector3d(0.45, -0.35, 0.6)}) {
    const View view{lens, looking_at({eye}, {{0.0, 0.2, 0.03}})};
    append(proxy, depth_proxy(render({.printed_pages = printed_pages}, view, threads).depth, view, 5, 0.03));
  }
  return proxy;
}

}  // namespace telepalp::mixed
