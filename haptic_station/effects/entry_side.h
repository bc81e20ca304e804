#pragma once

#include <algorithm>

#include "haptic_station/effects/effect.h"

namespace telepalp::effects {

/// Depth of a point inside a closed shape, with its derivative.
struct SolidDepth {
  double m = 0.0;                                      ///< positive inside
  Eigen::Vector3d outwards = Eigen::Vector3d::Zero();  ///< minus the gradient of `m`; unit near the surface
};

/// The part of a shape's force at one tick that the hand feels: `share` k `depth_m` `outwards`, with stiffness k.
struct FeltSolid {
  double depth_m = 0.0;                                ///< depth of the proxy; 0: the shape is not touched
  Eigen::Vector3d outwards = Eigen::Vector3d::Zero();  ///< at the proxy, as in SolidDepth
  double share = 0.0;                                  ///< share of the shape's stiffness that acts, 0 to 1
};

/// The god-object (proxy) of a shape inside the body: remembers from which side the device pushes into the shape, and
/// evaluates the force at a proxy. The proxy is the device, until the device has passed the middle of the shape: the
/// deepest point on the ray from the device towards that side. Then the proxy is this deepest point, so the proxy never
/// reaches the far face. Once the device has passed the middle, the force k s outwards(proxy), with the stiffness k and
/// the depth s of the proxy, has no component along the push.
///
/// For a given side, s is the greatest depth on the ray from the device towards that side, and the force is minus the
/// gradient of 1/2 k s^2 (envelope theorem), so it is conservative. Before the middle, the force equals that of paper
/// S1 (docs/sources.md), which is k times the device's depth. The side of entry may change only while the device has
/// not passed the middle, where a change alters neither force nor energy: a device that slides round a shape within 2
/// mm of its surface feels S1's force on all sides. Once the device has left through the far face, the force fades
/// within 0.1 s, which dissipates energy, and EntrySide forgets the side.
class EntrySide {
 public:
  /// Contact with the skin begins.
  void forget() noexcept { *this = {}; }

  /// One tick. `depth_at(point)` gives the SolidDepth of the shape. A device that entered on the side that faces the
  /// skin is taken to push against `skin_normal`, the skin's normal; on other sides the push is the device's motion.
  template <class DepthAt>
  [[nodiscard]] FeltSolid step(const Eigen::Vector3d& device, const Eigen::Vector3d& skin_normal, double dt_s,
                               const DepthAt& depth_at) noexcept {
    const Eigen::Vector3d came_from = trail(device);
    SolidDepth here = depth_at(device);
    const bool inside = here.m > 0.0;
    if (share_ <= 0.0) {
      if (!inside) return {};
      enter(device, here, skin_normal);
    }
    // Lowering the stiffness of a deformed spring takes energy out; raising it would create energy.
    if (!inside) share_ = std::max(0.0, share_ - dt_s / kLetGo_s);
    if (inside && here.outwards.dot(towards_) >= 0.0)
      follow(device, here, skin_normal.dot(face_) >= kOblique ? skin_normal : came_from);
    else
      here = deepest_above(device, depth_at);
    if (here.m <= 0.0) share_ = 0.0;
    return share_ > 0.0 ? FeltSolid{here.m, here.outwards, share_} : FeltSolid{};
  }

 private:
  static constexpr double kLetGo_s = 0.1;
  static constexpr double kShallow_m = 0.002;  ///< a device less deep than this slides on the surface
  static constexpr double kLeash_m = 0.005;    ///< length of path over which the direction of a push is measured
  static constexpr double kOblique = 0.5;      ///< least cosine between `face_` and the entry side of a deep device
  static constexpr double kSearch_m =
      0.004;  ///< half range of the search about the last proxy; enough for speeds up to 8 m/s
  static constexpr int kHalvings = 14;  ///< bisections of the search: to 0.5 um

  /// Unit vector against the device's motion over its last 5 mm; zero while it has moved less than 1 mm.
  [[nodiscard]] Eigen::Vector3d trail(const Eigen::Vector3d& device) noexcept {
    if (!has_trail_) trail_ = device;
    has_trail_ = true;
    const Eigen::Vector3d back = trail_ - device;
    const double length_m = back.norm();
    if (length_m > kLeash_m) trail_ = device + back * (kLeash_m / length_m);
    return length_m > 0.2 * kLeash_m ? Eigen::Vector3d(back / length_m) : Eigen::Vector3d::Zero();
  }

  void enter(const Eigen::Vector3d& device, const SolidDepth& here, const Eigen::Vector3d& skin_normal) noexcept {
    const double length = here.outwards.norm();
    towards_ = face_ = length > 0.5 ? Eigen::Vector3d(here.outwards / length) : skin_normal;
    middle_m_ = towards_.dot(device);
    share_ = 1.0;
  }

  /// Used while the proxy is the device. For a shallow device the side of entry is the surface's outward direction
  /// there; for a deeper one it is `from`, the direction from which the device is pushed.
  void follow(const Eigen::Vector3d& device, const SolidDepth& here, const Eigen::Vector3d& from) noexcept {
    if (here.m <= kShallow_m)
      towards_ = face_ = here.outwards.normalized();
    else if (from.dot(face_) >= kOblique && from.dot(here.outwards) >= 0.0)
      towards_ = from;
    middle_m_ = towards_.dot(device);
  }

  /// The deepest point on the ray from the device towards the entry side: where the depth's derivative along the ray
  /// changes sign, near the proxy of the last tick. `middle_m_` is its coordinate along the entry side.
  template <class DepthAt>
  [[nodiscard]] SolidDepth deepest_above(const Eigen::Vector3d& device, const DepthAt& depth_at) noexcept {
    const double along_m = towards_.dot(device);
    const auto at = [&](double m) noexcept { return depth_at(device + (m - along_m) * towards_); };
    double low_m = std::max(along_m, middle_m_ - kSearch_m);
    double high_m = std::max(low_m, middle_m_ + kSearch_m);
    for (int i = 0; i < kHalvings; ++i) {
      const double half_m = 0.5 * (low_m + high_m);
      (at(half_m).outwards.dot(towards_) < 0.0 ? low_m : high_m) = half_m;
    }
    middle_m_ = high_m;
    return at(high_m);
  }

  Eigen::Vector3d towards_ = Eigen::Vector3d::Zero();  ///< unit, to the side from which the device pushes
  Eigen::Vector3d face_ = Eigen::Vector3d::Zero();     ///< unit, outward normal at the device's last shallow point
  Eigen::Vector3d trail_ = Eigen::Vector3d::Zero();    ///< point that the device drags behind it, at most kLeash_m away
  double middle_m_ = 0.0;                              ///< coordinate of the proxy along `towards_`
  double share_ = 0.0;                                 ///< acting share of the stiffness; 0: the shape is not touched
  bool has_trail_ = false;
};

}  // namespace telepalp::effects
