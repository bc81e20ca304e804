#pragma once

#include <Eigen/Core>
#include <memory>

#include "haptic_station/mechanism/held_linkage.h"
#include "tools/study/task/design.h"
#include "tools/study/task/linkage_places.h"
#include "tools/study/task/plant.h"

namespace telepalp::study {

/// The tip begins this far above the skin.
inline constexpr double kAbove_m = 0.005;

/// How the needle is held: by a four-bar linkage, or directly.
class HeldTool {
 public:
  virtual ~HeldTool() = default;
  virtual void step(const Eigen::Vector3d& hand_m, double dt_s) noexcept = 0;
  [[nodiscard]] virtual Eigen::Vector3d tip_m() const noexcept = 0;
  [[nodiscard]] virtual Eigen::Vector3d axis() const noexcept = 0;
  [[nodiscard]] virtual Eigen::Vector3d hand_force_N(const Eigen::Vector3d& at_tip_N) const noexcept = 0;
  /// Force that keeps the hand on its path.
  [[nodiscard]] virtual Eigen::Vector3d guide_force_N() const noexcept = 0;
  /// Place on the path of the hand, at the distance `way_m` from its beginning [m].
  [[nodiscard]] virtual Eigen::Vector3d on_the_way_m(double way_m) const noexcept = 0;
  [[nodiscard]] virtual MechanismPicture picture() const noexcept = 0;
};

/// The linkage of `configuration`, with what it leaves to `plant`: link 4 and the needle's length.
[[nodiscard]] mechanism::FourBar bar_of(const Configuration& configuration, const Plant& plant) noexcept;

/// The linkage of `configuration` on `plant`, held at the handle's end, its tip kAbove_m above the skin. The tip
/// touches the sac while link 3 has the angle Plant::link3_rad. All lies in the plane z = 0 of the tissue's frame.
/// Error: the links cannot close on the way.
[[nodiscard]] Result<mechanism::HeldLinkage> placed_linkage(const Configuration& configuration, const Plant& plant);
/// The mechanism of `configuration` as a tool: placed_linkage(), or planar_tool() of another kind.
[[nodiscard]] Result<std::unique_ptr<HeldTool>> linkage_tool(const Configuration& configuration, const Plant& plant);
/// A needle in the hand that moves along y alone, as in Gerovich 2004.
[[nodiscard]] std::unique_ptr<HeldTool> straight_tool();

}  // namespace telepalp::study
