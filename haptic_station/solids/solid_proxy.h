#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "haptic_station/solids/near_members.h"
#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// Result of SolidProxy::step().
struct ProxyAt {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();        ///< proxy [m]; the device point while nothing is touched
  Eigen::Vector3d outwards = Eigen::Vector3d::Zero();  ///< unit, from the device to the proxy; zero without touch
  double depth_m = 0.0;                                ///< distance from device to proxy; 0: nothing is touched
};

/// How exactly the proxy is found; docs/accuracy.md has the error and cost of each value.
struct ProxySettings {
  int rounds = 6;             ///< steps along the surface in a tick, at most
  double tolerance_m = 1e-6;  ///< the proxy is on the surface within this distance
  bool remembers = true;      ///< evaluates only the parts near a slow hand, see NearMembers
};

/// The proxy (god-object) of a solid: the point outside the solid that follows the device and stops at the surface. A
/// spring from device to proxy is an inner layer of paper S2 (docs/sources.md). Up to three tangent planes hold the
/// proxy, at most one for each part (shape, blend or clip) of the solid, so that it rests in a crease between two ribs.
/// A fast device is swept from the last proxy on, so a thin wall stops it and keeps it on the side from which it came.
/// A device that is outside the solid and more than kTorn_m from its proxy was pushed right through the solid: the
/// proxy jumps to the device, which discards the spring's energy. While the device rests, the proxy lies on the surface
/// within ProxySettings::tolerance_m. Sources: S2 III.A; Zilles and Salisbury 1995; Salisbury and Tarr 1997. Owner: the
/// haptic thread. Nothing allocates.
class SolidProxy {
 public:
  static constexpr double kTorn_m = 0.03;  ///< at this length a spring of 800 N/m has 24 N, beyond what a device gives

  explicit SolidProxy(const ProxySettings& settings = {}) noexcept : settings_(settings) {}

  /// Ends the touch: the next step() starts the proxy at its device point, or, if that is inside the solid, near the
  /// nearest point of the surface (for a single shape, at that point).
  void forget() noexcept { *this = SolidProxy(settings_); }

  /// One tick. `device`: in the tree's frame [m]. `swell_m`: the touched surface lies this far outside the tree's
  /// surface, as for a pulsating artery; small compared with the solid.
  [[nodiscard]] ProxyAt step(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m = 0.0) noexcept;

 private:
  static constexpr int kMostSweeps = 32;
  static constexpr double kStride_m = 0.001;  ///< largest move of the proxy in a round
  static constexpr double kFlat = 0.1;        ///< a shorter gradient gives no plane: opposite walls are equally near

  struct Plane {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    std::uint32_t part = kNothing;
  };
  [[nodiscard]] SolidAt swollen_at(const SolidTree& tree, const Eigen::Vector3d& p, double swell_m) noexcept;
  void start(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m) noexcept;
  [[nodiscard]] bool sweep(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m) noexcept;
  void slide(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m) noexcept;
  bool hold(const SolidAt& at) noexcept;
  void let_go(const Eigen::Vector3d& device) noexcept;
  [[nodiscard]] Eigen::Vector3d goal(const Eigen::Vector3d& device) const noexcept;

  ProxySettings settings_;
  NearMembers near_;
  Eigen::Vector3d proxy_ = Eigen::Vector3d::Zero();
  std::array<Plane, 3> planes_{};
  std::size_t count_ = 0;
  bool started_ = false;
};

}  // namespace telepalp::solids
