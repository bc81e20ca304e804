// The hard cases of mechanisms in the hand, with requirement and result. The printed table is the product:
//   mechanism_hard_cases_test | grep '^|'

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "haptic_station/mechanism/crank_range.h"
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
};

class MechanismHardCases : public HardCaseTable {};

TEST_P(MechanismHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, MechanismHardCases, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
