// The hard cases of the prism of finite elements, with requirement and result. The printed table is the product:
//   prism_hard_cases_test | grep '^|'

#include <string>

#include "haptic_station/tissue/fem/prism_touch.h"
#include "tests/haptic_station/tissue/fem/prism_runs.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using namespace telepalp::tissue;
using namespace std::chrono_literals;
using Eigen::Vector3d;
using ::testing::AssertionResult;

constexpr double kLong_m = 0.1;
constexpr double kRest_m = 1e-6 * kLong_m;
constexpr double kSlew_N = 0.0401;     // in a tick
constexpr double kRelease_N = 0.0101;  // in a tick
constexpr Nanoseconds kRun = 12ms;

/// Quick to step; what is judged here does not depend on the mesh.
PrismSettings coarse() { return {.grid = {.across = 1, .along = 4}, .spread_m = 0.01}; }

effects::FemPrismSettings recipe(const PrismSettings& settings = coarse()) {
  return {.model = *make_prism_model(settings), .slew = {}};
}

/// Moves the tool at up to 0.1 m/s, with runs of the slow stage that take `cost`.
void move(PrismRun& run, const Vector3d& to_m, Nanoseconds cost = kRun, double speed_m_per_s = 0.1) {
  const Vector3d from_m = run.at_m();
  const int ticks = std::max(1, static_cast<int>((to_m - from_m).norm() / (speed_m_per_s * kTickOfPlane_s)));
  for (int i = 1; i <= ticks; ++i) run.tick(from_m + (to_m - from_m) * i / ticks, cost);
}
void rest(PrismRun& run, double seconds, Nanoseconds cost = kRun) {
  for (double t = 0.0; t < seconds; t += kTickOfPlane_s) run.tick(run.at_m(), cost);
}

/// A tool that has pressed the right side 6 mm deep.
PrismRun pressed(const effects::FemPrismSettings& settings) {
  PrismRun run(settings, {0.02, 0.09, 0.0});
  rest(run, 0.1);
  move(run, {0.004, 0.09, 0.0});
  rest(run, 0.3);
  return run;
}

Claim booked(const PrismRun& run) {
  Claim claim = figure("all booked", run.unbooked_J() < 1e-12, run.unbooked_J(), 1e3, "mJ");
  claim.holds = claim.holds && run.least_tank_J() >= 0.0;
  return claim;
}

AssertionResult returns(const std::function<void(NodeField&)>& spoil) {
  ElasticMotion motion((*make_prism_model({}))->body, 40.0);
  NodeField at = motion.body().rest();
  spoil(at);
  motion.put(at);
  const double before_J = motion.elastic_J();
  double most_J = 0.0;
  for (int i = 0; i < 180; ++i) {
    (void)motion.step(1.0 / 60.0, nullptr);
    most_J = std::max(most_J, motion.elastic_J() + motion.kinetic_J());
  }
  return all_of({{std::isfinite(before_J), "finite"},
                 {most_J <= before_J * (1.0 + 1e-12), "no energy gained"},
                 below_m("back at rest", away_m(motion), kRest_m)});
}

AssertionResult inverted_prism() {
  return returns([](NodeField& at) { at.row(0) *= -1.0; });
}
AssertionResult inverted_element() {
  return returns([](NodeField& at) { at.col(at.cols() / 2) += Vector3d(0.025, -0.03, 0.02); });
}
AssertionResult flat_prism() {
  return returns([](NodeField& at) { at.row(1).setZero(); });
}
AssertionResult point_prism() {
  return returns([](NodeField& at) { at.setZero(); });
}

/// The energy of inverted elements may have a false minimum here.
AssertionResult mirrored_prism() {
  PrismTouch touch(*make_prism_model({}));
  NodeField at = touch.motion().body().rest();
  at.row(1) *= -1.0;
  touch.disturb(at);
  bool finite = true;
  for (int i = 0; i < 300; ++i) finite = touch.step({0.2, 0.0, 0.0}, 0.016).has_value() && finite;
  return all_of({{finite, "finite"}, below_m("at rest", away_m(touch.motion()), kRest_m)});
}

AssertionResult overload() {
  ElasticMotion motion((*make_prism_model({}))->body, 40.0);
  PatchContact push{.patch = top_of(motion.body().mesh()), .stiffness_N_per_m = 28000.0};
  double force_N = 0.0;
  for (int i = 1; i <= 120 && force_N < 100.0; ++i) {
    push.limit_m = -0.001 * i;
    for (int k = 0; k < 4; ++k) (void)motion.step(1.0 / 60.0, &push);
    force_N = 28000.0 * push.depth_m(motion.at());
  }
  settle(motion, 3.0);
  return all_of({above("pushed", force_N, 100.0, 1.0, "N"), below_m("back at rest", away_m(motion), kRest_m)});
}

Claim refused(const std::function<void(TetMesh&)>& spoil, const char* word) {
  TetMesh mesh = *make_prism({.across = 1, .along = 1});
  spoil(mesh);
  const Result<void> right = check(mesh);
  const std::string text = right.ok() ? "accepted" : right.error().what;
  return {text.find(word) != std::string::npos, text};
}

AssertionResult no_edge() {
  return all_of({refused([](TetMesh& mesh) { mesh.nodes[mesh.tetrahedra[0][1]] = mesh.nodes[mesh.tetrahedra[0][0]]; },
                         "edge without length")});
}
AssertionResult flat_tetrahedron() {
  return all_of({refused(
      [](TetMesh& mesh) {
        const auto& n = mesh.tetrahedra[0];
        mesh.nodes[n[3]] = mesh.nodes[n[0]] + mesh.nodes[n[1]] - mesh.nodes[n[2]];
      },
      "tetrahedron 0 is flat")});
}

AssertionResult late() {
  PrismRun run = pressed(recipe());
  const double before_N = run.force_N().norm();
  rest(run, 0.09, 400ms);
  const double held_N = run.force_N().norm();
  rest(run, 0.25, 400ms);
  const double released_N = run.force_N().norm();
  rest(run, 1.0);
  return all_of({above("pressed", before_N, 5.0, 1.0, "N"),
                 below_N("held: changes by", std::abs(held_N - before_N), 0.2),
                 below_N("then released to", released_N, 0.8 * before_N),
                 above("then felt again", run.force_N().norm(), 0.9 * before_N, 1.0, "N"),
                 below_N("step", run.worst_step_N(), kSlew_N), booked(run)});
}

AssertionResult never_ends() {
  PrismRun run = pressed(recipe());
  rest(run, 0.05, core::kNever);
  const double step_N = run.worst_step_N();
  rest(run, 2.0, core::kNever);
  move(run, {-0.02, 0.09, 0.0}, core::kNever);
  return all_of({below_N("force", run.force_N().norm(), 1e-12),
                 below_N("step", std::max(step_N, run.worst_step_N()), kSlew_N), booked(run)});
}

/// The stage's prism is spoiled while it is pressed. The local model is held over the run that diverges, and then
/// released, because the tool is inside the prism that begins at rest.
AssertionResult diverges() {
  const auto model = *make_prism_model(coarse());
  PrismTouch touch(model);
  SlewedPlane felt;
  Vector3d at_m(0.02, 0.09, 0.0);
  felt.begin(at_m);
  double worst_N = 0.0;
  double before_N = 0.0;
  double held_N = 0.0;
  bool had_none = false;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d to_m(std::max(0.004, 0.02 - 0.00004 * i), 0.09, 0.0);
    if (i == 1600) {
      NodeField bad = touch.motion().at();
      bad(0, 0) = std::nan("");
      touch.disturb(bad);
      before_N = felt.force_N();
    }
    if (i % 32 == 0) {
      const auto plane = touch.step(to_m, 0.016);
      had_none = had_none || !plane;
      if (plane) felt.take(*plane);
    }
    const double was_N = felt.force_N();
    const double moved_m = (to_m - at_m).norm();
    felt.step(to_m, kTickOfPlane_s, 1.0);
    worst_N = std::max(worst_N, std::abs(felt.force_N() - was_N) - felt.stiffness_N_per_m() * moved_m);
    if (i == 1620) held_N = felt.force_N();
    at_m = to_m;
  }
  return all_of({{had_none, "no model from that run"},
                 below_N("held: changes by", std::abs(held_N - before_N), 0.2),
                 below_N("released to", felt.force_N(), 1e-12),
                 below_N("step", worst_N, kSlew_N)});
}

AssertionResult passes_through() {
  PrismSettings settings = coarse();
  settings.lets_go_N = 15.0;
  PrismRun run(recipe(settings), {0.02, 0.07, 0.0});
  rest(run, 0.1);
  double wrong_N = 0.0;
  double most_N = 0.0;
  for (int i = 1; i <= 1200; ++i) {
    run.tick({0.02 - 0.00005 * i, 0.07, 0.0}, kRun);
    wrong_N = std::max(wrong_N, -run.force_N().x());
    most_N = std::max(most_N, run.force_N().norm());
  }
  const double behind_N = run.force_N().norm();
  rest(run, 1.0);
  const double left_N = run.force_N().norm();
  move(run, {-0.003, 0.07, 0.0});
  return all_of({below_N("never pulled through", wrong_N, 0.05), below_N("most", most_N, 60.0),
                 below_N("behind it", behind_N, most_N), below_N("left there", left_N, 1e-9),
                 above("then felt from the other side", -run.force_N().x(), 0.5, 1.0, "N"),
                 below_N("step", run.worst_step_N(), kSlew_N), booked(run)});
}

/// The model that takes the prism's place is three times as stiff.
AssertionResult stiffened() {
  HandOver hand({.held_s = 10.0});
  hand.begin({0.0, 0.0, 0.0});
  hand.plane.take(wall(1000, 0.0));
  hand.move({-0.008, 0.0, 0.0}, 0.1);
  const double before_J = hand.plane.energy_J();
  hand.plane.take(wall(3000, 0.0));
  hand.rest(2.0);
  const double added_J = hand.plane.energy_J() - before_J;
  return all_of({below_N("step", hand.worst_step_N, kSlew_N),
                 below_mJ("added no more than the tank had", added_J, 20.0 + 1e-9),
                 above("stiffer", hand.plane.stiffness_N_per_m(), 2999.0, 1.0, "N/m"),
                 below_mJ("not booked", hand.worst_unbooked_J, 1e-9)});
}

AssertionResult over_the_edge() {
  PrismRun run = pressed(recipe());
  move(run, {0.004, 0.099, 0.0});
  move(run, {0.004, 0.115, 0.0});
  rest(run, 0.8);
  const double above_N = run.force_N().norm();
  move(run, {-0.02, 0.115, 0.0});
  return all_of({below_N("above it", above_N, 1e-9), below_N("passing over it", run.force_N().norm(), 1e-9),
                 below_N("step", run.worst_step_N(), kSlew_N), booked(run)});
}

AssertionResult begins_inside() {
  PrismRun run(recipe(), {0.0, 0.05, 0.0});
  rest(run, 0.5);
  const double inside_N = run.force_N().norm();
  move(run, {0.02, 0.05, 0.0});
  rest(run, 0.1);
  move(run, {0.008, 0.05, 0.0});
  return all_of({below_N("inside", inside_N, 1e-12), above("from outside", run.force_N().x(), 0.5, 1.0, "N")});
}

AssertionResult tapped() {
  PrismRun run(recipe(), {0.013, 0.09, 0.0});
  rest(run, 0.1);
  for (int i = 0; i < 2000; ++i) run.tick({0.0105 + 0.001 * std::sin(0.2 * i), 0.09, 0.0}, kRun);
  return all_of({below_N("step", run.worst_step_N(), 0.05), booked(run)});
}

const HardCase kRows[] = {
    {"prism turned inside out sideways", "every element is inverted", "returns to rest", inverted_prism},
    {"one node pushed through its neighbours", "some elements are inverted", "returns to rest", inverted_element},
    {"prism pressed flat", "det F = 0, a rotation has no value", "returns to rest", flat_prism},
    {"prism shrunk to a point", "F = 0", "returns to rest", point_prism},
    {"prism mirrored at its floor", "its energy may have a false minimum", "at rest in the end", mirrored_prism},
    {"ten times the device's force", "far beyond small strains", "returns to rest", overload},
    {"an edge without length", "the shape functions have no gradient", "refused", no_edge},
    {"a flat tetrahedron", "its volume is zero", "refused", flat_tetrahedron},
    {"slow model 0.4 s late", "the local model is old", "held, released gently, felt again", late},
    {"slow model never ends", "no newer model comes", "held, then no force", never_ends},
    {"slow model diverges", "NaN", "held, released gently", diverges},
    {"hand passes through", "the far side would push it on", "let go, no pull, felt again", passes_through},
    {"stiffness raised while pressed", "adds energy, however slowly", "no step; the tank pays", stiffened},
    {"hand slides over the top's edge", "another side is nearer", "lets go without a step", over_the_edge},
    {"hand inside at the beginning", "it came through no side", "no force until it was outside", begins_inside},
    {"tapping at 64 Hz", "as fast as the slow stage", "no step, all booked", tapped},
};

class PrismHardCases : public HardCaseTable {};

TEST_P(PrismHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, PrismHardCases, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
