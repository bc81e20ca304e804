#include "tools/study/task/other_mechanism.h"

namespace telepalp::study {
namespace {

using mechanism::HeldMechanism;
using mechanism::PlanarDesign;

constexpr double kMm = 1e-3;
constexpr double kRad = 1.0;
constexpr std::string_view kKinds[] = {"slider-crank", "five-bar", "six-bar"};

mechanism::PlanarDesign planar_design(const OtherMechanism& mechanism) {
  if (const auto* const one = std::get_if<SliderCrankAt>(&mechanism))
    return mechanism::slider_crank_design(one->crank, one->crank_rad);
  if (const auto* const one = std::get_if<FiveBarAt>(&mechanism))
    return mechanism::five_bar_design(one->bar, one->joint_m);
  const auto& six = std::get<SixBarAt>(mechanism);
  return mechanism::six_bar_design(six.bar, six.link3_rad);
}

}  // namespace

std::optional<OtherMechanism> other_mechanism(std::string_view kind) {
  if (kind == kKinds[0]) return SliderCrankAt{};
  if (kind == kKinds[1]) return FiveBarAt{};
  if (kind == kKinds[2]) return SixBarAt{};
  return std::nullopt;
}

std::string_view kind_of(const OtherMechanism& mechanism) noexcept { return kKinds[mechanism.index()]; }

std::vector<OtherParameter> parameters_of(OtherMechanism& mechanism) {
  if (auto* const one = std::get_if<SliderCrankAt>(&mechanism))
    return {{"crank", &one->crank.crank_m, kMm},
            {"rod", &one->crank.rod_m, kMm},
            {"handle", &one->crank.handle_m, kMm},
            {"needle", &one->crank.needle_m, kMm},
            {"at", &one->crank_rad, kRad}};
  if (auto* const one = std::get_if<FiveBarAt>(&mechanism))
    return {{"base", &one->bar.base_m, kMm},
            {"left", &one->bar.left_m, kMm},
            {"left_far", &one->bar.left_far_m, kMm},
            {"right", &one->bar.right_m, kMm},
            {"right_far", &one->bar.right_far_m, kMm},
            {"needle", &one->bar.needle_m, kMm},
            {"x", &one->joint_m.x(), kMm},
            {"y", &one->joint_m.y(), kMm}};
  auto& six = std::get<SixBarAt>(mechanism);
  return {
      {"l1", &six.bar.bar.l1_m, kMm},      {"l2", &six.bar.bar.l2_m, kMm},         {"l3", &six.bar.bar.l3_m, kMm},
      {"l4", &six.bar.bar.l4_m, kMm},      {"phi", &six.bar.bar.handle_rad, kRad}, {"h", &six.bar.bar.handle_at_m, kMm},
      {"l_h", &six.bar.bar.handle_m, kMm}, {"arm", &six.bar.arm_m, kMm},           {"rod", &six.bar.rod_m, kMm},
      {"rocker", &six.bar.rocker_m, kMm},  {"pivot", &six.bar.pivot_m, kMm},       {"needle", &six.bar.needle_m, kMm},
      {"at", &six.link3_rad, kRad}};
}

Result<OtherInPose> in_pose(const OtherMechanism& mechanism) {
  constexpr double kThere = 1e-6;  // [m or rad]
  PlanarDesign design = planar_design(mechanism);
  Result<HeldMechanism> held = mechanism::assembled(design.mechanism, design.near);
  if (!held) return held.error();
  if ((held->pose() - design.near).cwiseAbs().maxCoeff() > kThere)
    return Error{.what = "the joints do not close in the pose in which the tip touches the sac",
                 .where = "study",
                 .fix = "change the lengths, or this pose"};
  return OtherInPose{std::move(design), std::move(*held)};
}

}  // namespace telepalp::study
