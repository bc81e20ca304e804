#pragma once

#include "haptic_station/tissue/fem/energy_tank.h"
#include "haptic_station/tissue/fem/local_plane.h"

namespace telepalp::tissue {

struct SlewSettings {
  double slew_N_per_s = 80.0;     ///< so fast the force goes to that of a newer model: 0.04 N in a tick
  double release_N_per_s = 20.0;  ///< so fast a force ends whose model is too old
  double held_s = 0.1;            ///< a model is held so long
  double tank_J = 0.02;           ///< level of the tank when a contact begins
  double tank_holds_J = 0.2;
  double stiffest_N_per_m = 4000.0;  ///< a stiffer model is displayed with this stiffness
};

/// The spring that the haptic thread displays: it follows the local models of a slow computation, and a newer model
/// never changes the force in a step. At the moment of the change the spring has the old force; then
///
/// - its stiffness becomes that of the new model at once, with the depth at which the force is the same;
/// - its direction turns and its depth changes towards those of the new model, by at most SlewSettings::slew_N_per_s.
///
/// The energy that these changes add to the spring at a resting tool is paid from a tank, however slowly they happen; a
/// stiffer model at the same place adds 1/2 dK x^2 in all. What the tank cannot pay is not done. Where the body is
/// nowhere near, and where the direction turns by more than 60 degrees, the force first ends at that rate.
///
/// A model that is older than SlewSettings::held_s is released: the force falls to zero and stays there until a newer
/// model comes. Owner: haptic thread.
class SlewedPlane {
 public:
  explicit SlewedPlane(const SlewSettings& settings = {}) noexcept
      : settings_(settings), tank_(settings.tank_J, settings.tank_holds_J) {}

  /// A contact of the tool begins; the last model remains.
  void begin(const Eigen::Vector3d& tool_m) noexcept;
  /// A newer model. One that is not usable and not empty is ignored.
  void take(const LocalPlane& model) noexcept;
  /// The tool is at `tool_m`, `dt_s` later. `shown`: share of the spring's force that was displayed since the last
  /// step; what could not be displayed fills no tank.
  void step(const Eigen::Vector3d& tool_m, double dt_s, double shown) noexcept;

  [[nodiscard]] double depth_m() const noexcept { return depth_m_ > 0.0 ? depth_m_ : 0.0; }
  /// Negative: the tool is so far before the plane.
  [[nodiscard]] double signed_depth_m() const noexcept { return depth_m_; }
  [[nodiscard]] double stiffness_N_per_m() const noexcept { return stiffness_N_per_m_; }
  [[nodiscard]] const Eigen::Vector3d& normal() const noexcept { return normal_; }
  [[nodiscard]] double force_N() const noexcept { return stiffness_N_per_m_ * depth_m(); }
  [[nodiscard]] double energy_J() const noexcept { return 0.5 * force_N() * depth_m(); }
  [[nodiscard]] const EnergyTank& tank() const noexcept { return tank_; }
  [[nodiscard]] bool follows() const noexcept { return follows_; }  ///< false: there is no model, or it is too old
  [[nodiscard]] const LocalPlane& model() const noexcept { return model_; }

 private:
  void begin_force() noexcept;
  void stiffen() noexcept;
  double turn(double most_N) noexcept;
  void release(double by_N, double deeper_m) noexcept;
  void deepen(double wanted_m, double most_N) noexcept;

  SlewSettings settings_;
  EnergyTank tank_;
  LocalPlane model_;
  bool follows_ = false;
  double age_s_ = 0.0;
  double shown_ = 1.0;
  Eigen::Vector3d tool_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  double depth_m_ = 0.0;  ///< negative: the tool is so far from the plane
  double stiffness_N_per_m_ = 0.0;
};

}  // namespace telepalp::tissue
