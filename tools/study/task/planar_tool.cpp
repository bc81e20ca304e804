#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tools/study/task/other_mechanism.h"
#include "tools/study/task/tools.h"

namespace telepalp::study {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using mechanism::HeldMechanism;
using mechanism::PlanarDesign;

Vector2d needle_of(const PlanarDesign& design, const HeldMechanism& held) {
  return held.tip_m() - held.where_m(design.needle_from);
}

/// The path of the hand in the mechanism's frame: a circle about a pivot, or a straight line.
struct HandWay {
  std::optional<Vector2d> pivot_m;
  Vector2d from_m;
  Vector2d along;      ///< unit, at `from_m`
  double turns = 1.0;  ///< of a circle: +1 counter-clockwise, -1 clockwise

  [[nodiscard]] Vector2d at(double way_m) const noexcept {
    if (!pivot_m) return from_m + way_m * along;
    const Vector2d lever = from_m - *pivot_m;
    return *pivot_m + Eigen::Rotation2Dd(turns * way_m / lever.norm()) * lever;
  }
};

/// The mechanism's frame in the tissue's.
struct Placement {
  Eigen::Rotation2Dd turn{0.0};
  Vector2d origin_m = Vector2d::Zero();

  [[nodiscard]] Vector3d out(const Vector2d& at_m) const noexcept {
    const Vector2d there = origin_m + turn * at_m;
    return {there.x(), there.y(), 0.0};
  }
  [[nodiscard]] Vector2d in(const Vector3d& at_m) const noexcept {
    return turn.inverse() * (at_m.head<2>() - origin_m);
  }
  [[nodiscard]] Vector3d direction(const Vector2d& v) const noexcept {
    const Vector2d there = turn * v;
    return {there.x(), there.y(), 0.0};
  }
};

class PlanarTool final : public HeldTool {
 public:
  PlanarTool(PlanarDesign design, HeldMechanism held, const Placement& placement, const HandWay& way,
             double grip_N_per_m)
      : design_(std::move(design)),
        held_(std::move(held)),
        placement_(placement),
        way_(way),
        grip_N_per_m_(grip_N_per_m) {
    hand_m_ = on_the_way_m(0.0);
  }
  void step(const Vector3d& hand_m, double) noexcept override {
    held_.step(placement_.in(hand_m));
    hand_m_ = hand_m;
  }
  [[nodiscard]] Vector3d tip_m() const noexcept override { return placement_.out(held_.tip_m()); }
  [[nodiscard]] Vector3d axis() const noexcept override {
    return placement_.direction(needle_of(design_, held_).normalized());
  }
  [[nodiscard]] Vector3d hand_force_N(const Vector3d& at_tip_N) const noexcept override {
    return placement_.direction(held_.hand_force_N(placement_.turn.inverse() * at_tip_N.head<2>()));
  }
  [[nodiscard]] Vector3d guide_force_N() const noexcept override {
    return grip_N_per_m_ * (placement_.out(held_.grasp_m()) - hand_m_);
  }
  [[nodiscard]] Vector3d on_the_way_m(double way_m) const noexcept override { return placement_.out(way_.at(way_m)); }
  [[nodiscard]] MechanismPicture picture() const noexcept override {
    const auto place = [this](const mechanism::BodyPoint& point) -> Vector2d {
      return placement_.out(held_.where_m(point)).head<2>();
    };
    MechanismPicture out{.four_bar = std::nullopt,
                         .hand_m = placement_.out(held_.grasp_m()).head<2>(),
                         .needle_m = place(design_.needle_from),
                         .tip_m = tip_m().head<2>()};
    for (const mechanism::PlanarLine& link : design_.links) out.links[out.count++] = {place(link.from), place(link.to)};
    return out;
  }

 private:
  PlanarDesign design_;
  HeldMechanism held_;
  Placement placement_;
  HandWay way_;
  double grip_N_per_m_;
  Vector3d hand_m_;
};

/// Draws the needle out from `held`, whose tip touches the sac, until the tip has gone by `out_m` along `up`. Returns
/// how far the hand went along `back`; nullopt: the mechanism does not follow it so far.
std::optional<double> drawn_out_m(HeldMechanism& held, const HandWay& back, const Vector2d& up, double out_m) {
  constexpr double kStep_m = 5e-5;
  constexpr double kFurthest_m = 0.25;
  constexpr double kFollows_m = 5e-4;
  const Vector2d from_m = held.tip_m();
  for (double way_m = kStep_m; way_m < kFurthest_m; way_m += kStep_m) {
    held.step(back.at(way_m));
    if ((held.grasp_m() - back.at(way_m)).norm() > kFollows_m) return std::nullopt;
    if (up.dot(held.tip_m() - from_m) >= out_m) return way_m;
  }
  return std::nullopt;
}

/// The way on which the hand draws the needle out.
HandWay way_back(const PlanarDesign& design, const HeldMechanism& held, const Vector2d& up) {
  HandWay way{.pivot_m = design.hand_pivot_m, .from_m = held.grasp_m(), .along = up};
  if (!way.pivot_m) return way;
  constexpr double kTrial_m = 1e-3;
  HeldMechanism tried = held;
  tried.step(way.at(kTrial_m));
  if (up.dot(tried.tip_m() - held.tip_m()) < 0.0) way.turns = -1.0;
  return way;
}

}  // namespace

Result<std::unique_ptr<HeldTool>> planar_tool(const OtherMechanism& mechanism, const std::string& name,
                                              const Plant& plant) {
  Result<OtherInPose> made = in_pose(mechanism);
  if (!made) return Error{.what = name + ": " + made.error().what, .where = "study", .fix = made.error().fix};
  PlanarDesign& design = made->design;
  HeldMechanism& held = made->held;
  const Vector2d touches_m = held.tip_m();
  const Vector2d up = -needle_of(design, held).normalized();
  HandWay way = way_back(design, held, up);
  const std::optional<double> back_m = drawn_out_m(held, way, up, plant.sac_depth_m + kAbove_m);
  if (!back_m)
    return Error{.what = name + ": the mechanism cannot draw the needle out of the skin",
                 .where = "study",
                 .fix = "make its links longer, or give another pose at which the tip touches the sac"};
  Placement placement{.turn = Eigen::Rotation2Dd(std::numbers::pi / 2.0 - std::atan2(up.y(), up.x()))};
  placement.origin_m = Vector2d(0.0, -plant.sac_depth_m) - placement.turn * touches_m;
  way = {.pivot_m = way.pivot_m, .from_m = way.at(*back_m), .along = -way.along, .turns = -way.turns};
  return std::unique_ptr<HeldTool>(
      std::make_unique<PlanarTool>(std::move(design), std::move(held), placement, way, plant.grip_N_per_m));
}

}  // namespace telepalp::study
