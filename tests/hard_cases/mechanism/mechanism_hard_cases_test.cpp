// The hard cases of mechanisms in the hand, with requirement and result. The printed table is the product:
//   mechanism_hard_cases_test | grep '^|'

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "haptic_station/mechanism/crank_range.h"
#include "haptic_station/mechanism/felt_linkage.h"
#include "haptic_station/mechanism/held_linkage.h"
#include "haptic_station/mechanism/planar_designs.h"
#include "tests/haptic_station/periods.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using namespace telepalp::mechanism;
using ::testing::AssertionResult;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const Force<HapticBase> kNeedle{{1.0, 0.3, 0.0}};

FourBar links(double l1_mm, double l2_mm, double l3_mm, double l4_mm) {
  FourBar bar;
  bar.l1_m = 1e-3 * l1_mm;
  bar.l2_m = 1e-3 * l2_mm;
  bar.l3_m = 1e-3 * l3_mm;
  bar.l4_m = 1e-3 * l4_mm;
  return bar;
}

Point<HapticBase> hand_at(const FourBar& bar, double link3_rad) {
  const Lever lever = lever_of(bar);
  const double angle = link3_rad + lever.from_link3_rad;
  return {{bar.l4_m + lever.length_m * std::cos(angle), lever.length_m * std::sin(angle), 0.0}};
}

Claim refused(const Result<FourBar>& result, const std::string& word) {
  return {!result.ok() && result.error().what.find(word) != std::string::npos,
          result.ok() ? "accepted" : "\"" + result.error().what + "\""};
}

Claim finite(const HeldLinkage& held) {
  return {(held.tip().m + held.grasp().m + held.hand_force(kNeedle).N + held.constraint_force().N).allFinite(),
          "all finite"};
}

AssertionResult no_length() {
  return all_of({refused(checked(links(0, 150, 120, 130)), "l1 is 0 mm"),
                 refused(checked(links(80, 150, 120, 0)), "l4 is 0 mm")});
}

AssertionResult never_closes() { return all_of({refused(checked(links(80, 150, 120, 360)), "cannot close")}); }

AssertionResult not_a_number() {
  FourBar bar;
  bar.needle_rad = kNaN;
  HeldLinkage held({}, {}, 1.5, Branch::Open);
  const Eigen::Vector3d before = held.tip().m;
  held.step({{kNaN, 0.0, 0.0}}, kTick_s);
  return all_of({refused(checked(bar), "theta is not a finite number"),
                 {held.tip().m == before, "a hand that is NaN moves nothing"},
                 {held.hand_force({{kNaN, 0.0, 0.0}}).N.isZero() && held.constraint_force().N.isZero(), "no force"}});
}

AssertionResult dead_point() {
  const FourBar bar = links(80, 150, 120, 150);
  const CrankRange range = crank_range(bar, 1.5);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  for (int i = 0; i < 2000; ++i) held.step(hand_at(bar, 1.5 - 0.0005 * i), kTick_s);
  const double there = held.link3_rad();
  const double force_N = held.hand_force(kNeedle).N.norm();
  for (int i = 2000; i > 0; --i) held.step(hand_at(bar, 1.5 - 0.0005 * i), kTick_s);
  return all_of({below("link 3 stops at it", std::abs(there - range.from_rad), 1e-12, 1.0, "rad"),
                 below_N("the force is bounded", force_N, 5.0 * kNeedle.N.norm() + 1e-9),
                 {held.branch() == Branch::Open, "the way back is on the same branch"},
                 below("and to the same angle", std::abs(held.link3_rad() - 1.4995), 1e-9, 1.0, "rad")});
}

AssertionResult parallel_links() {
  const FourBar bar = links(100, 150, 100, 150);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  double worst_rad = 0.0;
  for (int i = 0; i < 8000; ++i) {
    held.step(hand_at(bar, 1.5 + 0.001 * i), kTick_s);
    const double link1_rad = std::atan2(held.pose().p.y, held.pose().p.x);
    worst_rad = std::max(worst_rad, std::abs(std::remainder(link1_rad - held.link3_rad(), 2.0 * std::numbers::pi)));
  }
  return all_of({{grashof_class(bar) == GrashofClass::ChangePoint, "a change point"},
                 below("links 1 and 3 stay parallel over a turn", worst_rad, 1e-6, 1.0, "rad"),
                 finite(held)});
}

AssertionResult at_the_line() {
  const FourBar bar = links(100, 150, 100, 150);
  HeldLinkage held(bar, {}, 0.0, Branch::Open);  // all joints on one line, exactly
  const Claim there = finite(held);
  held.step(hand_at(bar, 0.01), kTick_s);
  return all_of({there, finite(held)});
}

AssertionResult folded_rhombus() {
  const FourBar bar = links(100, 100, 100, 100);
  HeldLinkage held(bar, {}, 3.1, Branch::Open);
  held.step(hand_at(bar, std::numbers::pi), 1.0);  // joint B on pivot A: link 1 may have any angle
  const Claim there = finite(held);
  held.step(hand_at(bar, 3.2), 1.0);
  return all_of({there, finite(held)});
}

AssertionResult changed_at_dead_point() {
  const FourBar bar = links(80, 150, 120, 150);
  const double dead_rad = crank_range(bar, 1.5).from_rad;
  HeldLinkage held(bar, {}, dead_rad, Branch::Open);
  FourBar longer = bar;
  longer.l4_m = 0.17;  // the dead point moves into the way of the hand, which is held still
  held.set(longer);
  const Point<HapticBase> hand = held.grasp();
  double step_N = 0.0;
  double last_N = 0.0;
  for (int i = 0; i < 8000; ++i) {
    held.step(hand, kTick_s);
    const double now_N = held.constraint_force().N.norm() + held.hand_force(kNeedle).N.norm();
    if (i > 0) step_N = std::max(step_N, std::abs(now_N - last_N));
    last_N = now_N;
  }
  return all_of({below_N("no step of the force", step_N, 0.05),
                 {held.bar().l4_m == 0.17, "the change is complete"},
                 finite(held)});
}

AssertionResult class_changes_in_use() {
  HeldLinkage held(links(80, 150, 120, 130), {}, 1.5, Branch::Open);
  held.set(links(100, 100, 100, 80));  // from one class to another, on the way through lengths of both
  const Point<HapticBase> hand = held.grasp();
  double travel_m = 0.0;
  Eigen::Vector3d last = held.tip().m;
  for (int i = 0; i < 8000; ++i) {
    held.step(hand, kTick_s);
    travel_m = std::max(travel_m, (held.tip().m - last).norm());
    last = held.tip().m;
  }
  return all_of({below_m("the tip moves little each tick", travel_m, 1e-4), finite(held)});
}

AssertionResult hand_on_pivot() {
  const FourBar bar = links(80, 150, 120, 130);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  held.step({{bar.l4_m, 0.0, 0.02}}, kTick_s);
  return all_of({{held.link3_rad() == 1.5, "link 3 stays"}, finite(held)});
}

AssertionResult far_off_plane() {
  const FourBar bar = links(80, 150, 120, 130);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  Point<HapticBase> hand = hand_at(bar, 1.51);
  hand.m.z() = 0.05;
  held.step(hand, kTick_s);
  return all_of({below("it follows the hand's projection", std::abs(held.link3_rad() - 1.51), 1e-12, 1.0, "rad"),
                 below_N("and draws the hand back: 25 N less", std::abs(held.constraint_force().N.z() + 25.0), 1e-9)});
}

AssertionResult five_bar_stretched() {
  const PlanarDesign design = five_bar_design({}, {0.05, 0.15});
  HeldMechanism held = *assembled(design.mechanism, design.near);
  for (int i = 0; i < 400; ++i) held.step({0.05, 0.15 + 0.001 * i});  // out of reach
  const Eigen::Vector2d force_N = held.hand_force_N({1.0, 0.3});
  return all_of({below_m("all joints are closed", held.open_m(), 1e-7),
                 {force_N.allFinite(), "the force is finite"},
                 below_N("and bounded", force_N.norm(), 10.0)});
}

constexpr FeltSettings kFelt;

FeltLinkage felt_linkage(const FourBar& bar = links(80, 150, 120, 131)) {
  return *FeltLinkage::make(HeldLinkage(bar, {}, 1.5, Branch::Open));
}
Eigen::Vector3d place(const InPlane<double>& at, double z_m = 0.0) { return {at.x, at.y, z_m}; }

/// Moves the hand evenly, and returns the largest step of the force beyond the spring's own.
double felt_step_N(FeltLinkage& felt, Eigen::Vector3d& hand, const Eigen::Vector3d& to, bool pressed, int ticks) {
  const Eigen::Vector3d each = (to - hand) / ticks;
  double most_N = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const Eigen::Vector3d before = felt.contact_force().N;
    hand += each;
    felt.step({hand}, pressed, kTick_s);
    const double own_N = kFelt.stiffness_N_per_m * each.norm();
    most_N = std::max(most_N, (felt.contact_force().N - before).norm() - own_N);
  }
  return most_N;
}

AssertionResult fast_hand_at_the_needle() {
  FeltLinkage felt = felt_linkage();
  const Eigen::Vector3d middle = 0.5 * (place(felt.pose().p) + place(felt.pose().tip));
  felt.step({middle + Eigen::Vector3d(0, 0, 0.02)}, false, kTick_s);
  felt.step({middle - Eigen::Vector3d(0, 0, 0.02)}, false, kTick_s);  // 80 m/s, through 7.4 mm
  const double N = felt.contact_force().N.z();
  return all_of({{felt.touched() == LinkPart::Needle, "it is stopped by the needle"},
                 below_N("and held on the side from which it came: 11.85 N less", std::abs(N - 11.85), 0.01)});
}

AssertionResult around_a_joint() {
  FeltLinkage felt = felt_linkage();
  const Eigen::Vector3d joint = place(felt.pose().p);  // of links 1 and 2, where the needle begins
  Eigen::Vector3d hand = joint + Eigen::Vector3d(0, 0, 0.006);
  felt.step({joint + Eigen::Vector3d(0, 0, 0.03)}, false, kTick_s);
  double most_N = felt_step_N(felt, hand, hand, false, 400);
  most_N = 0.0;
  for (int turn = 0; turn <= 80; ++turn) {
    const double rad = 2.0 * std::numbers::pi * turn / 80;
    const Eigen::Vector3d to = joint + 0.01 * Eigen::Vector3d(std::cos(rad), std::sin(rad), 0.5);
    most_N = std::max(most_N, felt_step_N(felt, hand, to, false, 100));
  }
  return all_of({below_N("no step where one rod ends and the next begins", most_N, 0.05)});
}

AssertionResult grasp_deep_in_two_parts() {
  FeltLinkage felt = felt_linkage();
  const Eigen::Vector3d joint = place(felt.pose().p);
  Eigen::Vector3d hand = joint + Eigen::Vector3d(0, 0, 0.03);
  (void)felt_step_N(felt, hand, joint + Eigen::Vector3d(0.004, -0.004, 0.004), false, 400);
  const double most_N = felt_step_N(felt, hand, hand, true, 1000);
  return all_of({{felt.held().has_value(), "it takes hold"}, below_N("without a step", most_N, 0.05)});
}

AssertionResult grasp_at_a_pivot() {
  FeltLinkage felt = felt_linkage();
  felt.hold(LinkPart::Link1, {Eigen::Vector3d::Zero()});  // pivot A, which does not move
  const Eigen::Vector3d tip = felt.tip().m;
  for (int i = 0; i < 400; ++i) felt.step({{0.0001 * i, 0.0, 0.0}}, true, kTick_s);
  return all_of({below_m("nothing moves", (felt.tip().m - tip).norm(), 1e-9),
                 {felt.hand_force(kNeedle).N.allFinite() && felt.contact_force().N.allFinite(), "finite"}});
}

AssertionResult link1_through_the_handles_dead_point() {
  FeltLinkage felt = felt_linkage();  // link 1 can turn fully, link 3 rocks: it turns back twice in each turn
  felt.hold(LinkPart::Link1, {place(felt.pose().p)});
  const double from_rad = std::atan2(felt.pose().p.y, felt.pose().p.x);
  double most_N = 0.0;
  double worst_m = 0.0;
  double least_sine = 1.0;
  double last_sine = felt.sine_of_links();
  int crossed = 0;
  for (int i = 0; i <= 6000; ++i) {
    const double rad = from_rad + 2.0 * std::numbers::pi * i / 6000;
    felt.step({0.08 * Eigen::Vector3d(std::cos(rad), std::sin(rad), 0.0)}, true, kTick_s);
    const FourBarPose<double> at = felt.pose();
    worst_m = std::max(worst_m, std::abs((place(at.p) - place(at.b)).norm() - 0.15));
    most_N = std::max(most_N, felt.hand_force(kNeedle).N.norm());
    crossed += std::signbit(last_sine) != std::signbit(felt.sine_of_links()) ? 1 : 0;
    last_sine = felt.sine_of_links();
    least_sine = std::min(least_sine, std::abs(last_sine));
  }
  const double turned = std::remainder(std::atan2(felt.pose().p.y, felt.pose().p.x) - from_rad, 2.0 * std::numbers::pi);
  return all_of({below("link 1 makes its turn", std::abs(turned), 1e-6, 1.0, "rad"),
                 {crossed == 2, std::to_string(crossed) + " dead points of the handle crossed"},
                 below_m("link 2 keeps its length", worst_m, 1e-9),
                 below_N("the force on the hand is bounded", most_N, 5.0 * kNeedle.N.norm() + 1e-9)});
}

AssertionResult let_go_inside_another_part() {
  const FourBar bar = links(80, 150, 120, 131);
  FeltLinkage felt = felt_linkage(bar);
  const Eigen::Vector3d on_link3 = 0.5 * (Eigen::Vector3d(bar.l4_m, 0, 0) + place(felt.pose().b));
  felt.hold(LinkPart::Handle, {on_link3});  // the handle lies on link 3: its axis is inside both
  Eigen::Vector3d hand = felt.proxy().m;
  (void)felt_step_N(felt, hand, hand + Eigen::Vector3d(0, 0, 0.004), true, 100);  // the grasp pulls with 2 N
  const double most_N = felt_step_N(felt, hand, hand, false, 600);
  const double swept_N = felt_step_N(felt, hand, hand + Eigen::Vector3d(0, 0, 0.03), false, 600);
  (void)felt_step_N(felt, hand, on_link3 + Eigen::Vector3d(0, 0, 0.005), false, 600);
  return all_of(
      {below_N("no step", std::max(most_N, swept_N), 0.05),
       below_N("felt again when the hand comes back: 2 N less", std::abs(felt.contact_force().N.z() - 2.0), 0.01)});
}

const HardCase kRows[] = {
    {"links of length zero", "the loop's equations are singular", "refused with the lengths", no_length},
    {"links too short to close", "no pose exists", "refused with the lengths", never_closes},
    {"parameters and hand not a number", "NaN would stay in the pose", "refused; the pose stays", not_a_number},
    {"dead point", "the needle's force has no bound at the hand", "stop, bounded force, same branch", dead_point},
    {"parallel links through one line", "two branches meet", "link 1 turns on", parallel_links},
    {"begin with all joints on one line", "no branch is known", "finite", at_the_line},
    {"rhombus folded onto a pivot", "link 1 may have any angle", "finite", folded_rhombus},
    {"parameters changed at a dead point", "the dead point moves to the hand", "no step", changed_at_dead_point},
    {"Grashof class changes in use", "the range of link 3 changes its kind", "no jump", class_changes_in_use},
    {"hand on the pivot", "the angle GOT has no value", "hold", hand_on_pivot},
    {"hand off the plane", "only the projection may turn links", "turn by it, pull back", far_off_plane},
    {"five-bar stretched out", "two degrees of freedom become one", "closed, finite, bounded", five_bar_stretched},
    {"fast hand at a thin needle", "a tick's travel is five times its width", "stopped", fast_hand_at_the_needle},
    {"hand slides around a joint", "three rods meet", "no step", around_a_joint},
    {"button pressed deep in two parts", "linkage has no mass: it could jump", "no step", grasp_deep_in_two_parts},
    {"grasp at a pivot", "no motion of the linkage moves the hand", "stay, finite", grasp_at_a_pivot},
    {"link 1 through the handle's dead point", "link 3 turns back, the branch changes", "goes on, bounded",
     link1_through_the_handles_dead_point},
    {"let go inside another part", "the proxy would have to leave both", "no step", let_go_inside_another_part},
};

class MechanismHardCases : public HardCaseTable {};

TEST_P(MechanismHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, MechanismHardCases, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
