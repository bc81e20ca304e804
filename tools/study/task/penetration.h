#pragma once

#include <memory>

#include "haptic_station/mechanism/held_linkage.h"
#include "haptic_station/tissue/layered_tissue.h"
#include "tools/study/person/operator.h"
#include "tools/study/task/design.h"
#include "tools/study/task/plant.h"

namespace telepalp::study {

/// One penetration. S4 section 6: the tip begins outside the skin, goes through three layers, and stops as soon as
/// possible.
struct Outcome {
  bool through = false;  ///< the sac was punctured
  bool stopped = false;  ///< after the puncture, the tip stopped before kLongest_s
  double overshoot_m =
      0.0;  ///< from the place of contact with the sac to where the tip stopped, along the needle at contact
  double deepest_m = 0.0;            ///< as overshoot_m, but to the deepest place that the tip reached
  double depth_at_puncture_m = 0.0;  ///< depth of the tip below the skin at the puncture
  double hand_drop_N = 0.0;          ///< how far the force on the hand falls at the puncture
  double most_hand_N = 0.0;          ///< largest force of the needle on the hand
  double seconds = 0.0;
  bool noticed = false;  ///< the operator noticed the puncture
};

/// The tip has stopped when it moves by less than 0.2 mm in 0.1 s. S4 takes successive equal coordinates of its device,
/// which a hand with tremor does not give.
inline constexpr double kStoppedMove_m = 0.0002;
inline constexpr double kStoppedOver_s = 0.1;
/// A penetration ends after this time whatever happens.
inline constexpr double kLongest_s = 30.0;
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
};

/// The linkage of `configuration` on `plant`, held at the handle's end, its tip kAbove_m above the skin. The tip touches
/// the sac while link 3 has the angle Plant::link3_rad. All lies in the plane z = 0 of the tissue's frame. Error: the
/// links cannot close on the way.
[[nodiscard]] Result<mechanism::HeldLinkage> placed_linkage(const Configuration& configuration, const Plant& plant);
/// The same as a tool.
[[nodiscard]] Result<std::unique_ptr<HeldTool>> linkage_tool(const Configuration& configuration, const Plant& plant);
/// A needle in the hand that moves along y alone, as in Gerovich 2004.
[[nodiscard]] std::unique_ptr<HeldTool> straight_tool();

/// All that one penetration depends on.
struct Penetration {
  HeldTool& tool;
  const std::shared_ptr<const tissue::TissueModel>& tissue;
  const Operator& person;
  Condition condition;
};
/// Runs at 2 kHz; `learned` gets the depth of this puncture, as the operator sensed it. Pure.
[[nodiscard]] Outcome penetrate(const Penetration& one, Learned& learned, device::Random& random) noexcept;

}  // namespace telepalp::study
