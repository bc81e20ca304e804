#pragma once

#include <Eigen/Core>

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
  int rounds = 20;            ///< steps along the surface in a tick, at most
  double tolerance_m = 1e-6;  ///< the proxy is on the surface within this distance
  bool remembers = true;      ///< evaluates only the parts near a slow hand, see NearMembers
};

/// The proxy (god-object) of a solid: the point outside the solid that follows the device and stops at the surface. A
/// spring from device to proxy is an inner layer of paper S2 (docs/sources.md). Each part of the solid (shape, blend or
/// clip) within Walls::kNear_m of the proxy holds it by its tangent plane, up to eight parts at once; so it rests in a
/// crease between two ribs and in the corner of a room, at the point nearest to the device.
/// A fast device is swept from the last proxy on, so a thin wall stops it and keeps it on the side from which it came.
/// A device that is outside the solid and more than kTorn_m from its proxy was pushed right through the solid: the
/// proxy jumps to the device, which discards the spring's energy. While the device rests, the proxy lies on the surface
/// within ProxySettings::tolerance_m. Sources: S2 III.A; Zilles and Salisbury 1995; Ruspini, Kolarov and Khatib 1997
/// (constraint planes); Ortega, Redon and Coquillart 2007 (the nearest point that all constraints allow). Owner: the
/// haptic thread. Nothing allocates.
class SolidProxy {
 public:
  static constexpr double kTorn_m = 0.03;  ///< at this length a spring of 800 N/m has 24 N, beyond what a device gives

  explicit SolidProxy(const ProxySettings& settings = {}) noexcept : settings_(settings) {}

  /// Ends the touch: the next step() starts the proxy at its device point, or, if that is inside the solid, near the
  /// nearest point of the surface (for a single shape, at that point).
  void forget() noexcept { *this = SolidProxy(settings_); }

  /// The same, but the next step() starts the proxy at `at`, a point on the surface or outside.
  void start_at(const Eigen::Vector3d& at) noexcept {
    forget();
    proxy_ = at;
    started_ = true;
  }

  /// One tick. `device`: in the tree's frame [m]. `swell_m`: the touched surface lies this far outside the tree's
  /// surface, as for a pulsating artery; small compared with the solid.
  [[nodiscard]] ProxyAt step(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m = 0.0) noexcept;

 private:
  static constexpr int kMostSweeps = 32;

  [[nodiscard]] SolidAt value(const SolidTree& tree, double swell_m) noexcept;
  [[nodiscard]] Walls walls(const SolidTree& tree, double swell_m) noexcept;
  void start(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m) noexcept;
  [[nodiscard]] bool sweep(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m) noexcept;
  [[nodiscard]] bool stopped(const SolidTree& tree, const Eigen::Vector3d& way, double swell_m) noexcept;
  void slide(const SolidTree& tree, const Eigen::Vector3d& device, double swell_m) noexcept;
  void push_out(const Eigen::Vector3d& otherwise) noexcept;

  ProxySettings settings_;
  NearMembers near_;
  Eigen::Vector3d proxy_ = Eigen::Vector3d::Zero();
  Walls walls_{};  ///< at the proxy; none: nothing is touched
  bool started_ = false;
};

}  // namespace telepalp::solids
