#include "tools/study/task/tools.h"

#include <cmath>

namespace telepalp::study {
namespace {

using Eigen::Vector3d;
using mechanism::FourBar;
using mechanism::HeldLinkage;

class LinkageTool final : public HeldTool {
 public:
  LinkageTool(const HeldLinkage& held, double lever_m, double from_rad) noexcept
      : held_(held), lever_m_(lever_m), from_rad_(from_rad) {}
  void step(const Vector3d& hand_m, double dt_s) noexcept override { held_.step({hand_m}, dt_s); }
  [[nodiscard]] Vector3d tip_m() const noexcept override { return held_.tip().m; }
  [[nodiscard]] Vector3d axis() const noexcept override { return held_.needle_axis().v; }
  [[nodiscard]] Vector3d hand_force_N(const Vector3d& at_tip_N) const noexcept override {
    return held_.hand_force({at_tip_N}).N;
  }
  [[nodiscard]] Vector3d guide_force_N() const noexcept override { return held_.constraint_force().N; }
  [[nodiscard]] MechanismPicture picture() const noexcept override {
    const LinkagePlaces at = places_of(held_);
    return {.four_bar = at, .hand_m = at.c_m, .needle_m = at.p_m, .tip_m = at.tip_m};
  }
  [[nodiscard]] Vector3d on_the_way_m(double way_m) const noexcept override {
    const double angle = from_rad_ + way_m / lever_m_;
    const mechanism::LinkagePlane& plane = held_.plane();
    return plane.pivot_a.m + (held_.bar().l4_m + lever_m_ * std::cos(angle)) * plane.x.v +
           lever_m_ * std::sin(angle) * plane.y.v;
  }

 private:
  HeldLinkage held_;
  double lever_m_;
  double from_rad_;
};

class StraightTool final : public HeldTool {
 public:
  void step(const Vector3d& hand_m, double) noexcept override {
    tip_m_ = {0.0, hand_m.y(), 0.0};
    beside_m_ = hand_m - tip_m_;
  }
  [[nodiscard]] Vector3d tip_m() const noexcept override { return tip_m_; }
  [[nodiscard]] Vector3d axis() const noexcept override { return -Vector3d::UnitY(); }
  [[nodiscard]] Vector3d hand_force_N(const Vector3d& at_tip_N) const noexcept override {
    return {0.0, at_tip_N.y(), 0.0};
  }
  [[nodiscard]] Vector3d guide_force_N() const noexcept override { return -600.0 * beside_m_; }
  [[nodiscard]] Vector3d on_the_way_m(double way_m) const noexcept override { return {0.0, kAbove_m - way_m, 0.0}; }
  [[nodiscard]] MechanismPicture picture() const noexcept override {
    return {.hand_m = tip_m_.head<2>(), .needle_m = tip_m_.head<2>(), .tip_m = tip_m_.head<2>()};
  }

 private:
  Vector3d tip_m_{0.0, kAbove_m, 0.0};
  Vector3d beside_m_ = Vector3d::Zero();
};

/// The linkage's frame in H: its x axis points out of the patient.
mechanism::LinkagePlane plane_at(const Vector3d& pivot_a_m) {
  return {.pivot_a = {pivot_a_m}, .x = {Vector3d::UnitY()}, .y = {-Vector3d::UnitX()}};
}

Vector3d tip_at(const FourBar& bar, double link3_rad) {
  return HeldLinkage(bar, plane_at(Vector3d::Zero()), link3_rad, mechanism::Branch::Open).tip().m;
}

}  // namespace

FourBar bar_of(const Configuration& configuration, const Plant& plant) noexcept {
  FourBar bar = configuration.bar;
  if (!configuration.l4_given) bar.l4_m = plant.l4_of_l2 * bar.l2_m;
  if (!configuration.needle_given) bar.needle_m = plant.needle_m;
  return bar;
}

Result<HeldLinkage> placed_linkage(const Configuration& configuration, const Plant& plant) {
  const FourBar bar = bar_of(configuration, plant);
  const Result<FourBar> good = mechanism::checked_at(bar, plant.link3_rad);
  if (!good) return good.error();
  const Vector3d touches_m = tip_at(bar, plant.link3_rad);
  const double out_m = plant.sac_depth_m + kAbove_m;
  double begins_rad = plant.link3_rad;
  while (tip_at(bar, begins_rad).y() - touches_m.y() < out_m) {
    begins_rad -= 0.002;
    if (!mechanism::checked_at(bar, begins_rad) || begins_rad < plant.link3_rad - 1.5)
      return Error{.what = configuration.name + ": the linkage cannot draw the needle out of the skin",
                   .where = "study",
                   .fix = "make l4 shorter, or the links longer"};
  }
  const mechanism::LinkagePlane plane = plane_at(Vector3d(0.0, -plant.sac_depth_m, 0.0) - touches_m);
  return HeldLinkage(bar, plane, begins_rad, mechanism::Branch::Open, {.stiffness_N_per_m = plant.grip_N_per_m});
}

Result<std::unique_ptr<HeldTool>> linkage_tool(const Configuration& configuration, const Plant& plant) {
  if (configuration.other) {
    OtherMechanism other = *configuration.other;
    for (const OtherParameter& one : parameters_of(other))
      if (one.name == "needle" && !configuration.needle_given) *one.value = plant.needle_m;
    return planar_tool(other, configuration.name, plant);
  }
  const Result<HeldLinkage> held = placed_linkage(configuration, plant);
  if (!held) return held.error();
  const mechanism::Lever lever = mechanism::lever_of(held->bar());
  return std::unique_ptr<HeldTool>(
      std::make_unique<LinkageTool>(*held, lever.length_m, held->link3_rad() + lever.from_link3_rad));
}

std::unique_ptr<HeldTool> straight_tool() { return std::make_unique<StraightTool>(); }

}  // namespace telepalp::study
