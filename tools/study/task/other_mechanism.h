#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "haptic_station/mechanism/planar_designs.h"
#include "proto/words/result.h"

namespace telepalp::study {

class HeldTool;
struct Plant;

/// A slider-crank, and the crank's angle while the tip touches the sac.
struct SliderCrankAt {
  mechanism::SliderCrank crank;
  double crank_rad = 2.2;
};
/// A five-bar linkage, and the place of its joint while the tip touches the sac. The hand pushes it along the needle.
struct FiveBarAt {
  mechanism::FiveBar bar;
  Eigen::Vector2d joint_m{0.05, 0.16};
};
/// Watt's six-bar linkage, and the angle of link 3 while the tip touches the sac.
struct SixBarAt {
  mechanism::SixBar bar;
  double link3_rad = 1.5;
};
/// A mechanism that S4 leaves out, followed by the general solver (mechanism/planar_mechanism.h).
using OtherMechanism = std::variant<SliderCrankAt, FiveBarAt, SixBarAt>;

/// `kind` of a list: slider-crank, five-bar or six-bar. nullopt: another word.
[[nodiscard]] std::optional<OtherMechanism> other_mechanism(std::string_view kind);
[[nodiscard]] std::string_view kind_of(const OtherMechanism& mechanism) noexcept;

/// A parameter as lists name it; `value` is one of the mechanism's own numbers.
struct OtherParameter {
  std::string_view name;
  double* value = nullptr;
  double unit = 1.0;  ///< what one unit of text is in SI: 1e-3 for mm, 1 for rad
};
/// All parameters of `mechanism`, whose numbers they point to.
[[nodiscard]] std::vector<OtherParameter> parameters_of(OtherMechanism& mechanism);

/// The mechanism in the pose in which its tip touches the sac. Error: its joints do not close there.
struct OtherInPose {
  mechanism::PlanarDesign design;
  mechanism::HeldMechanism held;
};
[[nodiscard]] Result<OtherInPose> in_pose(const OtherMechanism& mechanism);

/// The mechanism on `plant`, as linkage_tool() places a four-bar linkage, but turned so that its needle is upright
/// where the tip touches the sac. Error: the joints cannot close there or on the way, or the hand cannot draw the
/// needle out.
[[nodiscard]] Result<std::unique_ptr<HeldTool>> planar_tool(const OtherMechanism& mechanism, const std::string& name,
                                                            const Plant& plant);

}  // namespace telepalp::study
