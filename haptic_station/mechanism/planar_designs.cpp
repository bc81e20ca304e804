#include "haptic_station/mechanism/planar_designs.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/mechanism/constraint_rows.h"
#include "haptic_station/mechanism/four_bar_pose.h"
#include "haptic_station/mechanism/link_parts.h"
#include "proto/words/error_line.h"

namespace telepalp::mechanism {
namespace {

constexpr double kAssembled_m = 1e-10;
constexpr double kSameAssembly = 1.0;  // [m or rad] a coordinate further from `near` means another assembly

Error mechanism_error(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "planar mechanism", .fix = std::move(fix)};
}

bool is_good(const BodyPoint& point, int bodies) {
  return point.body >= 0 && point.body <= bodies && point.at_m.allFinite();
}

Result<void> check(const PlanarMechanism& mechanism, const PlanarPose& near) {
  const int equations = 2 * mechanism.pins.size() + mechanism.slots.size();
  if (mechanism.bodies < 1 || mechanism.bodies > kMostBodies || equations > kMostEquations)
    return mechanism_error(
        std::to_string(mechanism.bodies) + " moving bodies with " + std::to_string(equations) + " equations of joints",
        "give 1 to " + std::to_string(kMostBodies) + " bodies and at most " + std::to_string(kMostEquations) +
            " equations: 2 for a pin, 1 for a slot");
  bool good = is_good(mechanism.grasp, mechanism.bodies) && is_good(mechanism.tip, mechanism.bodies);
  for (const Pin& pin : mechanism.pins)
    good &= is_good(pin.one, mechanism.bodies) && is_good(pin.other, mechanism.bodies);
  for (const Slot& slot : mechanism.slots)
    good &=
        is_good(slot.point, mechanism.bodies) && is_good(slot.line, mechanism.bodies) && std::isfinite(slot.line_rad);
  if (good && near.size() == 3 * mechanism.bodies && near.allFinite()) return {};
  return mechanism_error("a joint names no body of the mechanism, or a number is not finite",
                         "number the bodies from 1, 0 is the frame, and give finite lengths and angles");
}

BodyPoint at(int body, double x_m, double y_m = 0.0) { return {body, {x_m, y_m}}; }

/// Places `body` with its origin at `from` and its x axis towards `to`.
template <class Vector>
void place(PlanarPose& pose, int body, const Vector& from, const Vector& to) {
  pose.segment<3>(3 * (body - 1)) << from.x, from.y, std::atan2(to.y - from.y, to.x - from.x);
}

using P = InPlane<double>;

/// Where the circles of radius `one_m` about `one` and `other_m` about `other` meet. `side`: +1 for the point to the
/// left of the vector from `one` to `other`, -1 for the point to the right. Circles that do not meet: a point on their
/// line.
P meeting(const P& one, double one_m, const P& other, double other_m, double side) {
  FourBar bar;
  bar.l1_m = one_m;
  bar.l2_m = other_m;
  const P between = other - one;
  const Closing shares = closing(bar, between);
  const double across = side * std::sqrt(std::max(0.0, shares.across_squared));
  return one + shares.along * between + across * left_of(between);
}

}  // namespace

Result<HeldMechanism> assembled(const PlanarMechanism& mechanism, const PlanarPose& near) {
  if (const Result<void> good = check(mechanism, near); !good) return good.error();
  PlanarPose pose = near;
  double open_m = 0.0;
  for (int i = 0; i < 50; ++i) {
    const JointEquations equations = joint_equations(mechanism, pose);
    open_m = equations.errors.size() > 0 ? equations.errors.cwiseAbs().maxCoeff() : 0.0;
    if (open_m < 1e-15) break;
    pose += solutions_of(equations).one;
  }
  if (!(open_m < kAssembled_m) || !((pose - near).cwiseAbs().maxCoeff() < kSameAssembly))
    return mechanism_error(
        "the joints cannot close: the widest gap is " + number_text(std::round(1e6 * open_m) / 1e3) + " mm",
        "change the lengths, or begin nearer to a pose in which they close");
  HeldMechanism held(mechanism, pose);
  if (held.freedoms() == 1 || held.freedoms() == 2) return held;
  return mechanism_error("the mechanism has " + std::to_string(held.freedoms()) + " degrees of freedom",
                         "give joints that leave one or two");
}

PlanarDesign four_bar_design(const FourBar& bar, double link3_rad, bool open_branch) {
  const FourBarPose<double> pose = four_bar_pose(bar, link3_rad, open_branch ? 1.0 : -1.0);
  PlanarDesign design{.mechanism = {.bodies = 3,
                                    .pins = {{at(0, 0.0), at(1, 0.0)},
                                             {at(1, 0.0), at(2, 0.0)},
                                             {at(2, 0.0), at(3, 0.0)},
                                             {at(0, 0.0), at(3, 0.0)}},
                                    .slots = {},
                                    .grasp = {},
                                    .tip = {}},
                      .near = PlanarPose(9)};
  set_lengths(design.mechanism, bar);
  design.mechanism.grasp = on_part(bar, LinkPart::Handle, 1.0);
  place(design.near, 1, P{0.0, 0.0}, pose.p);
  place(design.near, 2, pose.b, pose.p);
  place(design.near, 3, P{bar.l4_m, 0.0}, pose.b);
  design.needle_from = on_part(bar, LinkPart::Needle, 0.0);
  design.hand_pivot_m = Eigen::Vector2d(bar.l4_m, 0.0);
  for (const LinkPart part : {LinkPart::Base, LinkPart::Link1, LinkPart::Link2, LinkPart::Link3, LinkPart::Handle})
    design.links.push_back({on_part(bar, part, 0.0), on_part(bar, part, 1.0)});
  return design;
}

PlanarDesign slider_crank_design(const SliderCrank& crank, double crank_rad) {
  PlanarDesign design{.mechanism = {.bodies = 3,
                                    .pins = {{at(0, 0.0), at(1, 0.0)},
                                             {at(1, crank.crank_m), at(2, 0.0)},
                                             {at(2, crank.rod_m), at(3, 0.0)}},
                                    .slots = {{at(3, 0.0), at(0, 0.0), 0.0}, {at(3, -crank.needle_m), at(0, 0.0), 0.0}},
                                    .grasp = at(1, crank.handle_m),
                                    .tip = at(3, -crank.needle_m)},
                      .near = PlanarPose::Zero(9)};
  const P end{crank.crank_m * std::cos(crank_rad), crank.crank_m * std::sin(crank_rad)};
  const double reach_m = std::sqrt(std::max(0.0, crank.rod_m * crank.rod_m - end.y * end.y));
  place(design.near, 1, P{0.0, 0.0}, end);
  place(design.near, 2, end, P{end.x - reach_m, 0.0});
  design.near[6] = end.x - reach_m;
  design.needle_from = at(3, 0.0);
  design.hand_pivot_m = Eigen::Vector2d::Zero();
  design.links = {
      {at(1, 0.0), at(1, crank.crank_m)}, {at(1, 0.0), at(1, crank.handle_m)}, {at(2, 0.0), at(2, crank.rod_m)}};
  return design;
}

PlanarDesign five_bar_design(const FiveBar& bar, const Eigen::Vector2d& joint_m) {
  PlanarDesign design{.mechanism = {.bodies = 4,
                                    .pins = {{at(0, 0.0), at(1, 0.0)},
                                             {at(1, bar.left_m), at(2, 0.0)},
                                             {at(2, bar.left_far_m), at(4, bar.right_far_m)},
                                             {at(3, bar.right_m), at(4, 0.0)},
                                             {at(0, bar.base_m), at(3, 0.0)}},
                                    .slots = {},
                                    .grasp = at(2, bar.left_far_m),
                                    .tip = at(2, bar.left_far_m + bar.needle_m)},
                      .near = PlanarPose(12)};
  const P joint{joint_m.x(), joint_m.y()};
  const P left = meeting({0.0, 0.0}, bar.left_m, joint, bar.left_far_m, 1.0);
  const P right = meeting({bar.base_m, 0.0}, bar.right_m, joint, bar.right_far_m, -1.0);
  place(design.near, 1, P{0.0, 0.0}, left);
  place(design.near, 2, left, joint);
  place(design.near, 3, P{bar.base_m, 0.0}, right);
  place(design.near, 4, right, joint);
  design.needle_from = at(2, bar.left_far_m);
  design.links = {{at(0, 0.0), at(0, bar.base_m)},
                  {at(1, 0.0), at(1, bar.left_m)},
                  {at(2, 0.0), at(2, bar.left_far_m)},
                  {at(3, 0.0), at(3, bar.right_m)},
                  {at(4, 0.0), at(4, bar.right_far_m)}};
  return design;
}

PlanarDesign six_bar_design(const SixBar& bar, double link3_rad) {
  PlanarDesign design = four_bar_design(bar.bar, link3_rad);
  PlanarMechanism& mechanism = design.mechanism;
  mechanism.bodies = 5;
  mechanism.pins.push_back({at(1, bar.bar.l1_m + bar.arm_m), at(4, 0.0)});
  mechanism.pins.push_back({at(4, bar.rod_m), at(5, bar.rocker_m)});
  mechanism.pins.push_back({at(0, bar.pivot_m), at(5, 0.0)});
  mechanism.tip = at(4, bar.rod_m + bar.needle_m);
  const PlanarPose four = design.near;
  design.near.resize(15);
  design.near.head<9>() = four;
  const FourBarPose<double> pose = four_bar_pose(bar.bar, link3_rad, 1.0);
  const P arm = (1.0 + bar.arm_m / bar.bar.l1_m) * pose.p;
  const P pivot{bar.pivot_m, 0.0};
  const P end = meeting(pivot, bar.rocker_m, arm, bar.rod_m, 1.0);
  place(design.near, 4, arm, end);
  place(design.near, 5, pivot, end);
  design.needle_from = at(4, bar.rod_m);
  design.links.push_back({at(1, bar.bar.l1_m), at(1, bar.bar.l1_m + bar.arm_m)});
  design.links.push_back({at(4, 0.0), at(4, bar.rod_m)});
  design.links.push_back({at(5, 0.0), at(5, bar.rocker_m)});
  return design;
}

}  // namespace telepalp::mechanism
