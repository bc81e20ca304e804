#pragma once

#include <Eigen/Core>

namespace telepalp::control {

/// The force that the device applies over a tick, split by cause [N]. The sum of the parts is the limiter's output.
/// Only the effects and the damping give a torque.
struct HeldForce {
  Eigen::Vector3d skin = Eigen::Vector3d::Zero();   ///< effects, damping, heat warning, and the limiter's change
  Eigen::Vector3d fade = Eigen::Vector3d::Zero();   ///< remaining force difference from the last phase transition
  Eigen::Vector3d drive = Eigen::Vector3d::Zero();  ///< lift, position control, and recall of workspace indexing
  Eigen::Vector3d torque_N_m = Eigen::Vector3d::Zero();
};

/// Compares the work of the device on the hand since the contact began with the work that a reference skin would have
/// done on the same path. In the station, the reference is the newest captured surface, predicted to now; in a
/// simulation, it is the true surface. The ledger of PassivityController counts motion relative to the displayed
/// surface; HandLedger counts motion in H, the haptic base's frame. It therefore includes the energy that the display
/// adds by its own motion, its delay and its fades. Owner: haptic thread.
class HandLedger {
 public:
  /// A contact begins; the balance starts at zero.
  void begin() noexcept { *this = HandLedger(); }

  /// Adds the last tick to the balance: the device gave `held` while it moved by `moved_m` [m, in H]. `reference_N`:
  /// the force of the reference skin after the movement. The reference's work is the mean of its forces before and
  /// after the movement, times the movement.
  void book(const HeldForce& held, const Eigen::Vector3d& reference_N, const Eigen::Vector3d& moved_m) noexcept {
    skin_J_ += (held.skin - 0.5 * (reference_N_ + reference_N)).dot(moved_m);
    fades_J_ += held.fade.dot(moved_m);
    drive_J_ += held.drive.dot(moved_m);
    reference_N_ = reference_N;
  }

  /// The same for the torque: the device gave `held` while it turned by `turned_rad` [rad, in H]. `reference_N_m`: the
  /// torque of the effects on the reference skin after the turn.
  void book_turn(const HeldForce& held, const Eigen::Vector3d& reference_N_m,
                 const Eigen::Vector3d& turned_rad) noexcept {
    skin_J_ += (held.torque_N_m - 0.5 * (reference_N_m_ + reference_N_m)).dot(turned_rad);
    reference_N_m_ = reference_N_m;
  }

  /// Work of the effects, the damping and the fades on the hand, minus the reference skin's work [J]. If it is above
  /// zero, the display gave the hand energy that the reference skin would not have given.
  [[nodiscard]] double excess_J() const noexcept { return skin_J_ + fades_J_; }
  [[nodiscard]] double fades_J() const noexcept { return fades_J_; }
  [[nodiscard]] double drive_J() const noexcept { return drive_J_; }  ///< work of HeldForce::drive

 private:
  Eigen::Vector3d reference_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d reference_N_m_ = Eigen::Vector3d::Zero();
  double skin_J_ = 0.0;
  double fades_J_ = 0.0;
  double drive_J_ = 0.0;
};

}  // namespace telepalp::control
