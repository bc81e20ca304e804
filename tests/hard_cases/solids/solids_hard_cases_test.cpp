// The hard cases of implicit solids, with requirement and result. The printed table is the product:
//   solids_hard_cases_test | grep '^|'

#include <cmath>
#include <numbers>
#include <string>

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_proxy.h"
#include "tests/haptic_station/periods.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using effects::EffectBank;
using Eigen::Vector3d;
using solids::ProxyAt;
using solids::SolidAt;
using solids::SolidProxy;
using solids::SolidTree;
using ::testing::AssertionResult;

std::shared_ptr<const SolidTree> tree_of(const std::string& text) {
  return *solids::build_tree(*solids::parse_polish(text, "case"));
}
SolidAt value(const std::string& text, const Vector3d& p) { return solids::solid_at(*tree_of(text), p); }
Claim near(const char* what, double value, double wanted, double within) {
  return below_m(what, std::abs(value - wanted), within);
}
Claim unit(const char* what, const Vector3d& gradient) {
  return below(what, std::abs(gradient.norm() - 1.0), 1e-9, 1.0, "");
}

ProxyAt driven(SolidProxy& proxy, const SolidTree& tree, const Vector3d& from, const Vector3d& to, int ticks) {
  ProxyAt at;
  for (int i = 0; i <= ticks; ++i) at = proxy.step(tree, from + (to - from) * i / ticks);
  return at;
}

AssertionResult fat_torus() {
  const auto tree = tree_of("torusx 0.01 0.03");
  const double cusp_m = std::sqrt(0.03 * 0.03 - 0.01 * 0.01);
  const SolidAt middle = solids::solid_at(*tree, Vector3d::Zero());
  SolidProxy proxy;
  const ProxyAt at = driven(proxy, *tree, {0.0, 0.06, 0.0}, {0.0, 0.002, 0.0}, 2000);
  return all_of({near("the axis is a cusp's depth inside", middle.m, -cusp_m, 1e-9),
                 unit("with a normal of length 1", middle.gradient),
                 near("the proxy is on the outer shell", at.at.norm(), 0.04, 1e-5)});
}

AssertionResult torus_axis() {
  const SolidAt axis = value("torusx 0.1 0.01", {0.02, 0.0, 0.0});
  const SolidAt again = value("torusx 0.1 0.01", {0.02, 0.0, 0.0});
  const SolidAt tube = value("torusx 0.1 0.01", {0.0, 0.0, 0.1});
  return all_of({unit("on the axis the normal has length 1", axis.gradient),
                 {axis.gradient == again.gradient, "twice the same"},
                 unit("in the tube's middle too", tube.gradient),
                 near("at its depth", tube.m, -0.01, 1e-12)});
}

AssertionResult exact_tie() {
  const std::string left = "tr -0.02 0 0 sphere 0.015 ";
  const std::string right = "tr 0.02 0 0 sphere 0.015 ";
  const Vector3d between(0.0, 0.01, 0.0);
  const SolidAt a = value("+ " + left + right, between);
  const SolidAt b = value("+ " + right + left, between);
  return all_of({{a.m == b.m && (a.gradient - b.gradient).norm() == 0.0, "the order of the operands does not matter"},
                 below("the normal leans to neither side", std::abs(a.gradient.x()), 1e-15, 1.0, "")});
}

AssertionResult point_capsule() {
  const Vector3d p(0.01, 0.03, -0.02);
  const SolidAt capsule = value("capsule 0.01 0 0 0.01 0 0 0.02", p);
  const SolidAt ball = value("tr 0.01 0 0 sphere 0.02", p);
  return all_of({{capsule.m == ball.m && capsule.gradient == ball.gradient, "it is the sphere, to the last bit"}});
}

/// Energy that a mass gives or takes while it bounces on a layer, as a share of what it had: the held force of a
/// sampled spring creates energy, and the bank's account must show it.
AssertionResult stiff_layer() {
  EffectBank bank;
  const auto layer =
      std::make_shared<const effects::SolidLayer>(effects::SolidLayer{"wall", tree_of("plane 0 1 0 0"), {}});
  (void)bank.add(effects::Solid({.layer = layer, .stiffness_N_per_m = 5000.0}));
  constexpr double kMass_kg = 0.05;  // k dt^2 / m = 0.025
  double y = 0.005;
  double speed = -0.2;
  effects::EffectInput in;
  in.contact.normal.v = Vector3d::UnitY();
  in.device.m = {0.0, y, 0.0};
  bank.begin(in);
  double account_J = 0.0;
  double worst_J = 0.0;
  const double begin_J = 0.5 * kMass_kg * speed * speed;
  for (int i = 0; i < 400; ++i) {
    in.moved.v = Vector3d(0.0, y, 0.0) - in.device.m;
    in.device.m = {0.0, y, 0.0};
    const double force_N = bank.step(in, kTick_s).force.N.y();
    account_J += bank.absorbed_J();
    const double mass_J = 0.5 * kMass_kg * speed * speed;
    worst_J = std::max(worst_J, std::abs(begin_J - mass_J - account_J));
    y += speed * kTick_s + 0.5 * force_N / kMass_kg * kTick_s * kTick_s;
    speed += force_N / kMass_kg * kTick_s;
  }
  return all_of({below_mJ("the account misses no created energy", worst_J, 1e-6),
                 above("the mass has left again", speed, 0.0, 1.0, "m/s")});
}

AssertionResult inclusion() {
  EffectBank bank;
  for (const auto& [text, k] :
       {std::pair{"tr 0 -0.06 0 sphere 0.05", 200.0}, std::pair{"tr 0.01 -0.03 0 sphere 0.01", 3000.0}})
    (void)bank.add(effects::Solid(
        {.layer = std::make_shared<const effects::SolidLayer>(effects::SolidLayer{"layer", tree_of(text), {}}),
         .stiffness_N_per_m = k}));
  effects::EffectInput in;
  in.contact.normal.v = Vector3d::UnitY();
  bank.begin(in);
  double taken_J = 0.0;
  double largest_step_N = 0.0;
  Vector3d last_N = Vector3d::Zero();
  constexpr int kTicks = 20'000;
  for (int i = 0; i <= kTicks; ++i) {
    const double turn = 2.0 * std::numbers::pi * 5.0 * i / kTicks;
    const double depth_m = 0.024 * std::min({1.0, i / 4000.0, (kTicks - i) / 4000.0});
    const Vector3d next(0.015 * std::sin(turn), -depth_m, 0.015 * (1.0 - std::cos(turn)));
    in.moved.v = next - in.device.m;
    in.device.m = next;
    const Vector3d now_N = bank.step(in, kTick_s).force.N;
    taken_J += bank.absorbed_J();
    largest_step_N = std::max(largest_step_N, (now_N - last_N).norm());
    last_N = now_N;
  }
  return all_of({above("five rounds over its edge give no energy", taken_J, -5e-4, 1e3, "mJ"),
                 below_N("no force step", largest_step_N, 0.25)});
}

AssertionResult tangent_union() {
  const auto tree = tree_of("+ tr -0.02 0 0 sphere 0.02 tr 0.02 0 0 sphere 0.02");
  const SolidAt touch = solids::solid_at(*tree, Vector3d::Zero());
  SolidProxy proxy;
  (void)driven(proxy, *tree, {0.0, 0.03, 0.0}, {0.0, -0.004, 0.0}, 2000);
  double chatter_m = 0.0;
  Vector3d last = proxy.step(*tree, {0.0, -0.004, 0.0}).at;
  for (int i = 0; i < 500; ++i) {
    const Vector3d now = proxy.step(*tree, {0.0, -0.004, 0.0}).at;
    chatter_m = std::max(chatter_m, (now - last).norm());
    last = now;
  }
  return all_of({{touch.gradient.norm() < 1e-12, "opposite normals cancel"},
                 {last.allFinite() && solids::solid_at(*tree, last).m > -2e-6, "the proxy is finite and outside"},
                 below_m("and does not chatter", chatter_m, 2e-6)});
}

/// The largest change of the proxy beyond the device's own motion while the device slides through `through`.
double proxy_step_m(const SolidTree& tree, const std::vector<Vector3d>& through) {
  SolidProxy proxy;
  double worst_m = 0.0;
  Vector3d before = proxy.step(tree, through.front()).at;
  for (std::size_t leg = 1; leg < through.size(); ++leg) {
    const Vector3d way = through[leg] - through[leg - 1];
    const int ticks = static_cast<int>(std::ceil(way.norm() / (0.3 * kTick_s)));
    for (int i = 1; i <= ticks; ++i) {
      const Vector3d now = proxy.step(tree, through[leg - 1] + way * i / ticks).at;
      worst_m = std::max(worst_m, (now - before).norm() - way.norm() / ticks);
      before = now;
    }
  }
  return worst_m;
}

AssertionResult flat_crease() {
  const auto tree = tree_of("+ plane 0.5 1 0 0 plane -0.5 1 0 0");
  const double step_m =
      proxy_step_m(*tree, {{0.0, 0.02, 0.0}, {0.0, -0.01, 0.0}, {0.02, -0.01, 0.01}, {-0.02, -0.005, 0.0}});
  SolidProxy proxy;
  const ProxyAt at = driven(proxy, *tree, {0.0, 0.02, 0.003}, {0.0, -0.01, 0.003}, 500);
  return all_of({below_m("no jump of the proxy", step_m, 1e-6),
                 near("it rests in the crease", (at.at - Vector3d(0.0, 0.0, 0.003)).norm(), 0.0, 2e-6)});
}

AssertionResult six_planes() {
  std::string text;
  for (int i = 0; i < 6; ++i) {
    const double turn = std::numbers::pi / 3.0 * i;
    if (i < 5) text += "+ ";
    text += "plane " + std::to_string(-std::cos(turn)) + " 0.7 " + std::to_string(-std::sin(turn)) + " 0 ";
  }
  const auto tree = tree_of(text);
  SolidProxy proxy;
  const ProxyAt at = driven(proxy, *tree, {0.0, 0.03, 0.0}, {0.001, -0.01, 0.0005}, 500);
  return all_of(
      {near("the proxy is their common point", at.at.norm(), 0.0, 5e-6),
       below_m("no jump on the way over it",
               proxy_step_m(*tree, {{0.0, 0.03, 0.0}, {0.004, -0.008, 0.0}, {-0.006, -0.004, 0.005}}), 1e-6)});
}

AssertionResult room_corner() {
  const auto tree = tree_of("- box 0.1 0.1 0.1 tr 0.02 0.02 0.02 box 0.04 0.04 0.04");  // a cavity in a block
  SolidProxy proxy;
  const ProxyAt at = driven(proxy, *tree, {0.02, 0.02, 0.02}, {-0.03, -0.03, -0.035}, 600);
  return all_of({near("the proxy is in the corner", (at.at - Vector3d(-0.02, -0.02, -0.02)).norm(), 0.0, 1e-5)});
}

AssertionResult nothing_left() {
  const std::string shape = "tx 0.01 0 0 30 1 1 0 box 0.02 0.01 0.03 ";
  SolidProxy whole;
  SolidProxy tiny;
  const auto nothing = tree_of("- " + shape + shape);
  const auto scaled = tree_of("sc 0.001 - box 20 10 30 box 20 10 30");
  double felt_m = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const Vector3d device(0.003, 0.05 - 0.00025 * i, 0.002);
    felt_m = std::max({felt_m, whole.step(*nothing, device).depth_m, tiny.step(*scaled, device).depth_m});
  }
  return all_of({below_m("nothing is felt", felt_m, 1e-9)});
}

AssertionResult no_finite_value() {
  std::string text;
  for (int i = 0; i < 60; ++i) text += "sc 0.000001 ";
  const auto solid = solids::parse_polish(text + "sphere 1", "case");
  const auto tree = solid.ok() ? solids::build_tree(*solid) : solid.error();
  return all_of(
      {{!tree.ok() && tree.error().what.find("no finite value") != std::string::npos, "refused, with a place"}});
}

AssertionResult thin_clip() {
  const auto tree = tree_of("clip 0 1 0 0.01 clip 0 -1 0 -0.0099 box 0.05 0.05 0.05");  // a sheet of 0.1 mm
  SolidProxy slow;
  SolidProxy fast;
  const ProxyAt pressed = driven(slow, *tree, {0.0, 0.02, 0.0}, {0.0, 0.005, 0.0}, 500);
  const ProxyAt struck = driven(fast, *tree, {0.0, 0.05, 0.0}, {0.0, 0.0, 0.0}, 2);
  return all_of({near("a slow hand is held on the front", pressed.at.y(), 0.01, 2e-6),
                 near("a hand at 50 m/s too", struck.at.y(), 0.01, 2e-6)});
}

AssertionResult sheet_beside_a_wall() {
  const auto tree = tree_of("+ plane 0 1 0 0 tr 0 0.002 0 box 0.05 0.00005 0.05");  // a sheet 2 mm over a wall
  SolidProxy proxy;
  (void)driven(proxy, *tree, {0.0, 0.001, 0.0}, {0.0, 0.0, 0.0}, 20);
  const ProxyAt at = proxy.step(*tree, {0.0, 0.003, 0.0});
  return all_of({near("the sheet holds it from below", at.at.y(), 0.00195, 2e-6)});
}

AssertionResult deep_tree() {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "blend 0.002 ro 3 0 0 1 ";
  text += "sphere 0.02";
  for (int i = 0; i < 50; ++i) text += " tr " + std::to_string(0.001 * i) + " 0 0 sphere 0.01";
  const SolidAt at = value(text, {0.0, 0.05, 0.0});
  const auto deeper = solids::parse_polish("ro 1 0 0 1 " + text + " ", "case");
  return all_of({{std::isfinite(at.m) && at.gradient.norm() <= 1.0 + 1e-9, "100 levels are evaluated"},
                 {deeper.ok() || deeper.error().what.find("nest deeper") != std::string::npos, "more are refused"},
                 {!solids::parse_polish("ro 1 0 0 1 ro 1 0 0 1 " + text, "case").ok(), "by the reader"}});
}

AssertionResult coincident_blend() {
  const Vector3d p(0.0, 0.04, 0.0);
  const SolidAt at = value("blend 0.008 sphere 0.03 sphere 0.03", p);
  return all_of({near("it swells by a quarter of the width", at.m, 0.01 - 0.002, 1e-12),
                 unit("and keeps its normal", at.gradient)});
}

AssertionResult scales() {
  double worst = 0.0;
  double worst_normal = 0.0;
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const auto tree =
        tree_of("sc " + std::to_string(scale) + " blend 0.3 torusx 1 0.2 tr 0.5 0 0 ellipsoid 0.4 0.5 0.6");
    const auto plain = tree_of("blend 0.3 torusx 1 0.2 tr 0.5 0 0 ellipsoid 0.4 0.5 0.6");
    for (int i = 0; i < 200; ++i) {
      const Vector3d p(std::sin(1.0 * i), std::sin(2.3 * i), std::sin(3.7 * i));
      const SolidAt scaled = solids::solid_at(*tree, scale * p);
      const SolidAt there = solids::solid_at(*plain, p);
      worst = std::max(worst, std::abs(scaled.m / scale - there.m));
      worst_normal = std::max(worst_normal, (scaled.gradient - there.gradient).norm());
    }
  }
  return all_of({below("the value scales along", worst, 1e-12, 1.0, ""),
                 below("the gradient stays", worst_normal, 1e-12, 1.0, "")});
}

AssertionResult far_away() {
  const auto near_tree = tree_of("torusx 0.18 0.009");
  const auto far_tree = tree_of("tr 900 900 900 torusx 0.18 0.009");
  const Vector3d p(0.004, 0.187, 0.01);
  const double there = solids::solid_at(*far_tree, p + Vector3d::Constant(900.0)).m;
  return all_of({near("1.5 km away it is as exact as the numbers", there, solids::solid_at(*near_tree, p).m, 1e-12)});
}

const HardCase kRows[] = {
    {"torus, tube wider than ring", "the tube meets itself on the axis", "measure to the outer shell", fat_torus},
    {"on a torus' axis, in its tube", "every direction is nearest", "a finite normal, always the same", torus_axis},
    {"exact tie of two solids", "two normals are right", "symmetric in the operands", exact_tie},
    {"capsule of no length", "its axis has no direction", "it is a sphere", point_capsule},
    {"stiff layer, light device", "k dt^2/m is large: sampling creates energy", "the account shows all of it",
     stiff_layer},
    {"stiff mass inside a soft organ", "stiffness jumps at its edge", "energy and force stay bounded", inclusion},
    {"two spheres that touch in a point", "the normals there cancel", "hold the last planes, no chatter",
     tangent_union},
    {"a crease of two flat walls", "both tie along a line", "rest in it, no jump", flat_crease},
    {"six planes in one point", "any three could hold the proxy", "rest in the point, no jump", six_planes},
    {"the corner of a room that is cut from a block", "three walls of one shape", "each holds the proxy", room_corner},
    {"a solid less itself", "a sheet without thickness would stay", "nothing is felt", nothing_left},
    {"60 scales of a millionth, nested", "their product is zero", "refused when it is read", no_finite_value},
    {"a sheet of 0.1 mm", "a tick crosses it", "stay on the side of entry", thin_clip},
    {"a sheet 2 mm from the touched wall", "a tick leaves the wall and crosses it", "stay between them",
     sheet_beside_a_wall},
    {"100 levels of operators", "recursion could overflow", "evaluated; more is refused", deep_tree},
    {"blend of a solid with itself", "the blend's width is full everywhere", "a stated swelling, no cusp",
     coincident_blend},
    {"scales from 1e-3 to 1e3", "thresholds in metres would show", "the same shape at each scale", scales},
    {"900 m from the origin", "coordinates lose digits", "lose only those", far_away},
};

class SolidsHardCases : public HardCaseTable {};

TEST_P(SolidsHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, SolidsHardCases, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
