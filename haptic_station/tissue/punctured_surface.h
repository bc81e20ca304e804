#pragma once

#include <array>

#include "haptic_station/tissue/bristle.h"
#include "haptic_station/tissue/mesh/triangle_tree.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// Removed: the needle is away from the layer. Touching: it deforms the layer. Inserted: it is through the layer.
enum class LayerState { Removed, Touching, Inserted };

/// The surface of one layer under a needle's tip (paper S4, docs/sources.md, section 3).
///
/// While the needle touches, the contact triangle sticks to the tip, and the force is the net's stiffness times the
/// tip's displacement from the place of contact (eq. 2 and 6). Where the sideways force exceeds `side_grip` times the
/// force along the normal, the place of contact follows the tip over the mesh, so that a tip that grazes the skin
/// slides off without a jump. Above the threshold the layer is punctured: the net goes back to its shape within
/// `falls_in_s`, and its energy is dissipated; however fast the tip goes on, the net never pushes with more than the
/// threshold. From then on the hole drags on the needle against its motion (eq. 3 and 7). S4's constant force along
/// -v / |v| is not defined at rest, where it would chatter; a Bristle carries the same force, and holds a resting
/// needle.
///
/// The net works from both sides. Positions are relative to the layer's mesh.
class PuncturedSurface {
 public:
  static constexpr std::size_t kMostHoles = 8;  ///< the ninth hole replaces the first

  void begin(const TissueModel& model, const Eigen::Vector3d& tip_m) noexcept;
  /// `may_puncture`: all layers outside this one are punctured.
  void step(const TissueModel& model, const LayerSettings& layer, const Eigen::Vector3d& from_m,
            const Eigen::Vector3d& to_m, bool may_puncture, double dt_s) noexcept;
  void yield(double share) noexcept;

  [[nodiscard]] LayerState state() const noexcept { return state_; }
  [[nodiscard]] bool falls() const noexcept { return state_ == LayerState::Inserted && whole_ > 0.0; }
  /// Share of the net that no longer acts on the needle, because it is in a hole.
  [[nodiscard]] double opened() const noexcept { return state_ == LayerState::Inserted ? 1.0 - whole_ : 0.0; }
  [[nodiscard]] std::size_t holes() const noexcept { return holes_ < kMostHoles ? holes_ : kMostHoles; }
  [[nodiscard]] std::size_t hole() const noexcept { return hole_; }       ///< index of the hole that the needle is in
  [[nodiscard]] bool fresh_hole() const noexcept { return fresh_hole_; }  ///< hole() was made in the last step
  [[nodiscard]] const Eigen::Vector3d& hole_m() const noexcept { return hole_at_m_[hole_]; }
  [[nodiscard]] bool from_inside() const noexcept { return side_ < 0.0; }
  [[nodiscard]] Eigen::Vector3d force_N(const LayerSettings& layer) const noexcept;
  [[nodiscard]] double stored_J(const LayerSettings& layer) const noexcept;
  [[nodiscard]] double stiffness_N_per_m(const LayerSettings& layer) const noexcept;
  [[nodiscard]] double puncture_dissipated_J() const noexcept { return dissipated_J_; }

 private:
  void meet(const TissueModel& model, const LayerSettings& layer, const Eigen::Vector3d& from_m,
            const Eigen::Vector3d& to_m) noexcept;
  void touch(const TissueModel& model, const MeshPoint& at, double side) noexcept;
  void stretch(const LayerSettings& layer, const Eigen::Vector3d& by_m) noexcept;
  void slide(const TissueModel& model, const LayerSettings& layer) noexcept;
  void puncture(const Eigen::Vector3d& tip_m) noexcept;
  void pass(const LayerSettings& layer, const Eigen::Vector3d& by_m, double depth_m, double dt_s) noexcept;
  void leave() noexcept;
  [[nodiscard]] std::size_t hole_near(const Eigen::Vector3d& at_m) const noexcept;  ///< index; kMostHoles: none
  [[nodiscard]] Eigen::Vector3d pulled_by_net_N(const LayerSettings& layer) const noexcept;
  [[nodiscard]] Eigen::Vector3d net_N(const LayerSettings& layer) const noexcept;
  [[nodiscard]] double net_J(const LayerSettings& layer) const noexcept;

  LayerState state_ = LayerState::Removed;
  double side_ = 1.0;  ///< +1: the needle comes or came from outside
  MeshPoint contact_;
  Eigen::Vector3d plane_m_ = Eigen::Vector3d::Zero();  ///< a point of the surface at rest, at the contact
  Eigen::Vector3d out_ = Eigen::Vector3d::UnitY();     ///< unit normal, to the side from which the needle came
  RelaxingSpring spring_;                              ///< from the place of contact to the tip
  Bristle drag_;
  double stiffness_ = 0.0;  ///< of the net at the contact, relative to its middle; during a contact it only falls
  double whole_ = 0.0;      ///< share of the net's force that acts
  double dissipated_J_ = 0.0;
  std::array<Eigen::Vector3d, kMostHoles> hole_at_m_{};
  std::size_t holes_ = 0;
  std::size_t hole_ = 0;
  bool fresh_hole_ = false;
};

}  // namespace telepalp::tissue
