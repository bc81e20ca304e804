#pragma once

#include "haptic_station/tissue/bristle.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// The needle in one layer, at one tick.
struct BulkMotion {
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();    ///< place of the tip, in H
  Eigen::Vector3d by_m = Eigen::Vector3d::Zero();    ///< motion of the tip since the last tick
  Eigen::Vector3d cuts = -Eigen::Vector3d::UnitY();  ///< unit vector along which the tip cuts
  double inside_m = 0.0;                             ///< length of the needle in the layer
  double uncut = 0.0;  ///< 0: the tip is not in uncut tissue of this layer; 1: it is fully in it
};

/// The inside of a thick layer, which holds a needle (paper S4, docs/sources.md, section 3, second layer).
///
/// With S4's laws, a spring joins the needle to the place where it stopped (eq. 4). Above the threshold it is removed,
/// and a damper acts until the needle stops again (eq. 5). S4 takes a run of equal coordinates for "stopped", which
/// depends on the device (BulkLaw::Paper). BulkLaw::Window takes a mean speed below 1 mm/s over 20 ms, and lets the
/// spring's force fall within 10 ms. BulkLaw::Bristle is dry friction that needs no such rule. Its greatest force is a
/// constant, which is reached over the first 2 mm, plus a part for each metre inside. While the tip goes forward in
/// uncut tissue, a second spring along `cuts` carries the force of cutting.
class Bulk {
 public:
  void step(const BulkSettings& bulk, const Relaxation& relaxation, const BulkMotion& motion, double dt_s) noexcept;
  void clear() noexcept { *this = Bulk(); }
  void yield(double share) noexcept;

  [[nodiscard]] Eigen::Vector3d force_N(const BulkSettings& bulk, const Relaxation& relaxation) const noexcept;
  [[nodiscard]] double stored_J(const BulkSettings& bulk, const Relaxation& relaxation) const noexcept;
  [[nodiscard]] bool slips() const noexcept { return slips_; }

 private:
  void stick_and_slip(const BulkSettings& bulk, const BulkMotion& motion, double most_N, double dt_s) noexcept;
  [[nodiscard]] bool stopped(const BulkSettings& bulk, const Eigen::Vector3d& at_m, double dt_s) noexcept;

  Bristle bristle_;
  RelaxingSpring cut_;  ///< along x: how far the tip bends the tissue in front of it
  Eigen::Vector3d cuts_ = -Eigen::Vector3d::UnitY();
  Eigen::Vector3d stretched_m_ = Eigen::Vector3d::Zero();  ///< extension of the spring of eq. (4): -R_s
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();     ///< of the slipping needle, smoothed over 5 ms [m/s]
  Eigen::Vector3d watched_m_ = Eigen::Vector3d::Zero();    ///< where the window or the run of equal readings began
  double watched_s_ = 0.0;
  int equal_ = 0;
  double whole_ = 1.0;  ///< share of the spring of eq. (4) that acts
  double damps_ = 0.0;  ///< damping that acts while the needle slips [N s/m]
  bool slips_ = false;
};

}  // namespace telepalp::tissue
