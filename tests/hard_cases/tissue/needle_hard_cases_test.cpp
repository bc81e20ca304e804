// The hard cases of a needle in layered tissue, with requirement and result. The printed table is the product:
//   needle_hard_cases_test | grep '^|'

#include <algorithm>
#include <map>

#include "tests/haptic_station/tissue/meshes.h"
#include "tests/haptic_station/tissue/needle_paths.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using namespace telepalp::tissue;
using Eigen::Vector3d;
using ::testing::AssertionResult;

constexpr double kStep_N = 0.05;  // in a tick, beyond what the stiffness gives

LayerState state(const Insertion& run, std::size_t layer = 0) { return run.tissue.layer(layer).state; }
Claim is_through(const char* what, bool through) { return {through, what}; }
Claim no_gain(const Insertion& run) {
  return figure("no energy", run.worst_gain_J <= 1e-12, run.worst_gain_J, 1e3, "mJ");
}

/// Pushes straight down in steps of `step_m` until layer 0 gives way, and returns the greatest force; 0: it never did.
double puncture_N(Insertion& run, double step_m = 1e-5) {
  double most_N = 0.0;
  for (int i = 0; i < 3000 && state(run) != LayerState::Inserted; ++i) {
    run.tick(run.needle.tip_m - Vector3d(0.0, step_m, 0.0));
    most_N = std::max(most_N, run.force_N.norm());
  }
  return state(run) == LayerState::Inserted ? most_N : 0.0;
}

AssertionResult tangential() {
  Insertion run(one_surface(), {-0.01, 0.001, 0.0});
  run.needle.axis = Vector3d::UnitX();
  run.move({-0.008, -0.0005, 0.0});
  const double pressed_N = run.force_N.norm();
  run.move({0.012, -0.0005, 0.0}, 0.1);
  const Vector3d sliding_N = run.force_N;
  run.move({0.012, 0.001, 0.0});
  return all_of({above("pressed", pressed_N, 0.1, 1.0, "N"),
                 below_N("slides", std::abs(sliding_N.x()), 0.61 * sliding_N.y()),
                 is_through("whole", !run.tissue.punctured(0)), below_N("step", run.worst_step_N, kStep_N),
                 below_N("left", run.force_N.norm(), 1e-12), no_gain(run)});
}

AssertionResult edges_and_vertices() {
  double least_N = 1e9;
  double most_N = 0.0;
  double step_N = 0.0;
  const double edge_m = one_surface().net_edge_m;
  for (const auto& [x, z] : {std::pair{0.0, 0.0}, {0.5 * edge_m, 0.0}, {0.5 * edge_m, edge_m / std::sqrt(12.0)}}) {
    Insertion run(one_surface(), {x, 0.001, z});
    const double at_N = puncture_N(run);
    least_N = std::min(least_N, at_N);
    most_N = std::max(most_N, at_N);
    step_N = std::max(step_N, run.worst_step_N);
  }
  return all_of(
      {above("least", least_N, 1.49, 1.0, "N"), below_N("most", most_N, 1.51), below_N("step", step_N, kStep_N)});
}

AssertionResult at_the_threshold() {
  Insertion run(one_surface(1.5, 0.0));
  run.move({0.0, -0.0045, 0.0});
  while (run.force_N.y() < 1.5 - 1e-6) run.tick(run.needle.tip_m - Vector3d(0.0, 1e-9, 0.0));
  const double held_N = run.force_N.y();
  run.rest(2.0);
  const double drift_N = std::abs(run.force_N.y() - held_N);
  const bool whole = state(run) == LayerState::Touching;
  double fall_N = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double before_N = run.force_N.y();
    run.tick(run.needle.tip_m - Vector3d(0.0, i == 0 ? 1e-7 : 0.0, 0.0));
    fall_N = std::max(fall_N, before_N - run.force_N.y());
  }
  return all_of({is_through("whole at rest", whole), below_N("drift", drift_N, 1e-9),
                 is_through("then through", state(run) == LayerState::Inserted), below_N("fall in a tick", fall_N, 0.5),
                 below_N("left", run.force_N.norm(), 1e-9)});
}

AssertionResult two_at_once() {
  TissueSettings two = one_surface(1.0);
  two.layers.push_back(two.layers[0]);
  two.layers[1].name = "under it";
  Insertion run(two);
  double most_N = 0.0;
  bool in_order = true;
  for (int i = 0; i < 2000; ++i) {
    run.tick(run.needle.tip_m - Vector3d(0.0, 1e-5, 0.0));
    most_N = std::max(most_N, run.force_N.norm());
    in_order = in_order && (state(run, 1) != LayerState::Inserted || state(run, 0) == LayerState::Inserted);
  }
  return all_of({is_through("in order", in_order), is_through("both through", state(run, 1) == LayerState::Inserted),
                 above("together", most_N, 1.9, 1.0, "N"), below_N("bounded", most_N, run.tissue.most_N() + 0.01),
                 below_N("step", run.worst_step_N, kStep_N), no_gain(run)});
}

/// Three nets within 0.1 mm; the needle goes 0.5 mm in a tick.
AssertionResult thinner_than_a_tick() {
  TissueSettings thin = one_surface(0.5);
  for (const double top_m : {0.00005, 0.0001}) {
    thin.layers.push_back(thin.layers[0]);
    thin.layers.back().top_m = top_m;
  }
  Insertion run(thin);
  double most_N = 0.0;
  for (int i = 0; i < 60; ++i) {
    run.tick(run.needle.tip_m - Vector3d(0.0, 0.0005, 0.0));
    most_N = std::max(most_N, run.force_N.norm());
  }
  const bool all = run.tissue.punctured(0) && run.tissue.punctured(1) && run.tissue.punctured(2);
  const double over_N = most_N - run.tissue.most_N();
  return all_of({is_through("each punctured", all), above("felt", most_N, 1.4, 1.0, "N"),
                 below_N("over the bound", over_N, 0.0), no_gain(run)});
}

AssertionResult from_inside() {
  Insertion run(three_layers(), {0.0, -0.045, 0.0});
  const double began_N = run.force_N.norm();
  double down_N = 0.0;
  bool sac = false;
  for (int i = 0; i < 3000; ++i) {
    run.tick(run.needle.tip_m + Vector3d(0.0, 1e-5, 0.0));
    down_N = std::max(down_N, -run.force_N.y());
    sac = sac || state(run, 2) == LayerState::Inserted;
  }
  return all_of({below_N("begins", began_N, 1e-12), is_through("sac gave way", sac),
                 above("pushed back", down_N, 0.7, 1.0, "N"), below_N("bounded", down_N, run.tissue.most_N() + 0.01),
                 below_N("step", run.worst_step_N, kStep_N), no_gain(run)});
}

/// The level disc without the triangles that reach within 6 mm of its middle.
SurfaceMesh holed_disc() {
  const SurfaceMesh whole = lattice_disc(0.03, 0.004);
  std::vector<Vector3d> vertices;
  std::map<std::uint32_t, std::uint32_t> kept;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& triangle : whole.triangles()) {
    if (std::ranges::any_of(triangle, [&](std::uint32_t v) { return whole.vertices()[v].norm() < 0.006; })) continue;
    std::array<std::uint32_t, 3> now{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [at, fresh] = kept.try_emplace(triangle[i], static_cast<std::uint32_t>(vertices.size()));
      if (fresh) vertices.push_back(whole.vertices()[triangle[i]]);
      now[i] = at->second;
    }
    triangles.push_back(now);
  }
  return *make_mesh(vertices, triangles);
}

AssertionResult mesh_with_a_hole() {
  TissueSettings holed = one_surface();
  holed.mesh = std::make_shared<const SurfaceMesh>(holed_disc());
  double in_hole_N = 0.0;
  Insertion through(holed);
  for (int i = 0; i < 1000; ++i) {
    through.tick(through.needle.tip_m - Vector3d(0.0, 2e-5, 0.0));
    in_hole_N = std::max(in_hole_N, through.force_N.norm());
  }
  Insertion beside(holed, {0.016, 0.002, 0.0});
  const double at_N = puncture_N(beside);
  Insertion over(holed, {0.016, 0.002, 0.0});
  over.move({0.016, -0.001, 0.0});
  over.move({0.0, -0.001, 0.0}, 0.05);
  return all_of({below_N("in the hole", in_hole_N, 1e-12), above("beside it", at_N, 1.49, 1.0, "N"),
                 below_N("slid over the rim", over.worst_step_N, kStep_N), no_gain(over)});
}

AssertionResult rests_on_the_skin() {
  Insertion run(one_surface(), {0.0, 0.002, 0.0});
  run.move({0.0, 0.0, 0.0});
  run.rest(1.0);
  const double on_N = run.force_N.norm();
  for (int i = 0; i < 2000; ++i) run.tick({0.0, i % 2 == 0 ? -1e-7 : 1e-7, 0.0});
  // The mean of a tick's two forces counts a tick that begins in the air too high, but going in and coming out alike.
  return all_of({below_N("at rest", on_N, 1e-9), below_N("dithers", run.force_N.norm(), 1e-3),
                 below_N("step", run.worst_step_N, kStep_N), below_mJ("energy", run.worst_gain_J, 1e-8)});
}

const HardCase kRows[] = {
    {"needle tangential to the skin", "no way into it, the tip grazes", "slides, no puncture, no step", tangential},
    {"through an edge and a vertex", "several triangles are touched", "the threshold's force", edges_and_vertices},
    {"stopped exactly at a threshold", "rounding decides", "whole at rest; then falls gently", at_the_threshold},
    {"two layers at once", "each holds the other's puncture off", "both, from the outside, bounded", two_at_once},
    {"layers thinner than a tick's travel", "a tick begins above and ends below", "each felt", thinner_than_a_tick},
    {"sac ruptured from inside", "the layers outside are whole", "it gives way, bounded", from_inside},
    {"mesh with a hole", "its rim has one side", "nothing in the hole, no step at the rim", mesh_with_a_hole},
    {"tip rests on the skin", "contact and none in turn", "no force, no step, no energy", rests_on_the_skin},
};

class NeedleHardCases : public HardCaseTable {};

TEST_P(NeedleHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, NeedleHardCases, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
