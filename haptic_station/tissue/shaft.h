#pragma once

#include <Eigen/Geometry>

#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// The hole in the outermost surface holds the needle's shaft sideways, as a spring from the hole to the nearest point
/// of the shaft. So a doctor who tilts or shifts a needle feels a lever. The spring's energy depends on its length
/// alone, and force and torque are its gradient. Above `tears_at_N_per_m` × the length inside, the hole gets longer; so
/// the force ends where the needle leaves.
class Shaft {
 public:
  /// The needle has come through the hole at `hole_m`. The first step() moves the hole onto the shaft.
  void enter(const Eigen::Vector3d& hole_m) noexcept {
    hole_m_ = hole_m;
    inside_ = true;
    fresh_ = true;
  }
  void leave() noexcept { *this = Shaft(); }
  [[nodiscard]] bool inside() const noexcept { return inside_; }

  void step(const ShaftSettings& shaft, const Eigen::Vector3d& tip_m, const Eigen::Vector3d& axis) noexcept {
    if (!inside_ || shaft.side_N_per_m <= 0.0) return;
    foot_m_ = (hole_m_ - tip_m).dot(axis) * axis;
    Eigen::Vector3d side_m = hole_m_ - tip_m - foot_m_;
    if (fresh_) side_m.setZero();
    fresh_ = false;
    const double longest_m = shaft.tears_at_N_per_m * std::max(0.0, -foot_m_.dot(axis)) / shaft.side_N_per_m;
    if (const double length_m = side_m.norm(); length_m > longest_m) side_m *= longest_m / length_m;
    hole_m_ = tip_m + foot_m_ + side_m;
    side_m_ = side_m;
  }
  [[nodiscard]] Eigen::Vector3d force_N(const ShaftSettings& shaft) const noexcept {
    return shaft.side_N_per_m * side_m_;
  }
  /// Torque about the tip.
  [[nodiscard]] Eigen::Vector3d torque_N_m(const ShaftSettings& shaft) const noexcept {
    return foot_m_.cross(force_N(shaft));
  }
  [[nodiscard]] double stored_J(const ShaftSettings& shaft) const noexcept {
    return 0.5 * shaft.side_N_per_m * side_m_.squaredNorm();
  }
  void yield(double share) noexcept {
    hole_m_ -= (1.0 - share) * side_m_;
    side_m_ *= share;
  }

 private:
  Eigen::Vector3d hole_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d foot_m_ = Eigen::Vector3d::Zero();  ///< from the tip to the shaft's point that is nearest to the hole
  Eigen::Vector3d side_m_ = Eigen::Vector3d::Zero();  ///< from that point to the hole
  bool inside_ = false;
  bool fresh_ = false;  ///< true from enter() to the next step()
};

}  // namespace telepalp::tissue
