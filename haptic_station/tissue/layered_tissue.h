#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <span>

#include "haptic_station/tissue/bulk.h"
#include "haptic_station/tissue/punctured_surface.h"
#include "haptic_station/tissue/shaft.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// A needle at one tick, in the frame of the tissue's settings (H).
struct NeedleMotion {
  Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();  ///< unit vector from the handle to the tip
  Eigen::Vector3d bevel = Eigen::Vector3d::UnitX();  ///< unit vector, perpendicular to `axis`, to which a bevel turns
};

/// State and force of a layer at the last tick.
struct LayerReading {
  LayerState state = LayerState::Removed;
  double depth_m = 0.0;  ///< depth of the tip below the layer's upper side at rest; negative above it
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();  ///< on the needle: F_li of paper S4 (docs/sources.md)
};

/// The wrench of the tissue on the needle.
struct TissueWrench {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_N_m = Eigen::Vector3d::Zero();  ///< about the tip
};

/// A needle in layers of tissue: paper S4 (docs/sources.md), section 3. The force is the sum of the layers' forces (S4
/// eq. 1). S4's three layers are surfaces; here a layer may also be thick, as S4 section 6.4 wishes.
///
/// - A surface (skin, sac) is a net of springs (PuncturedSurface). A layer is punctured only when all layers outside it
///   are. Holes last: a needle that comes back to a hole feels no second puncture, also after begin().
/// - A bulk (muscle, liver) sticks and slips (Bulk).
/// - The hole in the outermost surface holds the needle sideways (Shaft): its force has a lever to the tip.
///
/// Pure: the force depends on the motions since begin() alone. A step neither allocates, locks nor throws.
/// Owner: haptic thread.
class LayeredTissue {
 public:
  explicit LayeredTissue(std::shared_ptr<const TissueModel> model) noexcept : model_(std::move(model)) {}

  /// A contact begins. Holes are kept, all forces are zero. A tip that is at most 5 mm below a surface counts as come
  /// from outside; a deeper tip counts as come from inside.
  void begin(const NeedleMotion& needle) noexcept;
  [[nodiscard]] TissueWrench step(const NeedleMotion& needle, double dt_s) noexcept;

  [[nodiscard]] std::size_t size() const noexcept;
  [[nodiscard]] LayerReading layer(std::size_t index) const noexcept;
  [[nodiscard]] TissueWrench wrench() const noexcept;  ///< of the last step()
  /// True once a needle has punctured the layer anywhere.
  [[nodiscard]] bool punctured(std::size_t index) const noexcept { return surfaces_[index].holes() > 0; }
  /// Share of the outermost surface's net that no longer acts on the needle, because the needle is in its hole: 0 to
  /// 1. It rises while the force of a puncture falls.
  [[nodiscard]] double opened() const noexcept;
  /// The most energy that the needle could get back.
  [[nodiscard]] double stored_J() const noexcept;
  /// Energy of surfaces that punctures have dissipated since begin().
  [[nodiscard]] double punctures_dissipated_J() const noexcept;
  /// Lets all anchors follow the needle until the force is at most `share` of what it is; takes energy out.
  void yield(double share) noexcept;
  /// True while the force of a punctured net or of a slipped spring still falls.
  [[nodiscard]] bool falls() const noexcept;
  /// Upper bound of the stiffness of the layers that act now: |change of force| / |motion| where nothing slips or
  /// ruptures.
  [[nodiscard]] double stiffness_N_per_m() const noexcept;
  /// Upper bound of the tissue's force (force_bound.h), also while the tip pushes several nets at once. A fast tip can
  /// exceed it for a tick, by overshooting a puncture or by pulling a damper of S4's eq. (5).
  [[nodiscard]] double most_N() const noexcept;
  /// Greatest stiffness of all layers together at the middle of the nets. Near its fixed rim, a net is stiffer.
  [[nodiscard]] double stiffest_N_per_m() const noexcept;

 private:
  [[nodiscard]] Eigen::Vector3d local_m(const Eigen::Vector3d& tip_m, const LayerSettings& layer) const noexcept;
  void step_surfaces(const NeedleMotion& needle, double dt_s) noexcept;
  void step_bulks(const NeedleMotion& needle, double dt_s) noexcept;
  void step_shaft(const NeedleMotion& needle) noexcept;
  [[nodiscard]] bool open_down_to(std::size_t index) const noexcept;

  std::shared_ptr<const TissueModel> model_;
  std::array<PuncturedSurface, TissueSettings::kMostLayers> surfaces_;
  std::array<Bulk, TissueSettings::kMostLayers> bulks_;
  std::array<double, PuncturedSurface::kMostHoles> deepest_m_{};  ///< of the tip in each hole of the outer surface
  Shaft shaft_;
  Eigen::Vector3d tip_m_ = Eigen::Vector3d::Zero();  ///< the tip at the last step
};

}  // namespace telepalp::tissue
