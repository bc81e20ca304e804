#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "tests/haptic_station/tissue/needle_paths.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/forced_path.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using Eigen::Vector3d;
using ::testing::AssertionResult;
using tissue::LayerState;

/// Forces of the controller on a needle that follows a prescribed path through a tissue.
struct Needle {
  Felt felt;
  double most_N = 0.0;
  double most_sideways_N = 0.0;
  double last_N = 0.0;    ///< along y, at the last tick
  double ledger_J = 0.0;  ///< the most by which the display's ledger was below zero
};

Needle drive(const tissue::TissueSettings& settings, const std::function<Vector3d(double)>& path, double seconds,
             double watched_from_s = 0.0) {
  effects::EffectBank bank;
  (void)bank.add(effects::LayeredTissue({.model = *tissue::make_tissue(settings)}));
  ForcedPath scene{.seconds = ForcedPath::kDown_s + seconds, .effects = bank, .path = path};
  Needle needle;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    needle.ledger_J = std::max(needle.ledger_J, -out.passivity_J);
    if (now_s < ForcedPath::kDown_s + watched_from_s || !control::is_inside(out.phase)) return;
    needle.most_N = std::max(needle.most_N, out.force.N.norm());
    needle.most_sideways_N = std::max(needle.most_sideways_N, std::hypot(out.force.N.x(), out.force.N.z()));
    needle.last_N = out.force.N.y();
  };
  needle.felt = feel(scene);
  return needle;
}

Claim steady(const Needle& needle) {
  Claim claim = below_N("step", needle.felt.worst_step_N, kTick_N);
  claim.holds = claim.holds && needle.felt.finite && !needle.felt.faulted && needle.ledger_J < 1e-4;
  return claim;
}

/// From 1 mm above the skin down to `deep_m` at 20 mm/s, and then as `then` says.
std::function<Vector3d(double)> down_to(double deep_m, const std::function<Vector3d(double)>& then) {
  const double down_s = (deep_m + 0.001) / 0.02;
  return [=](double s) {
    return s < down_s ? Vector3d(0.0, 0.001 - 0.02 * s, 0.0) : Vector3d(then(s - down_s) - Vector3d(0.0, deep_m, 0.0));
  };
}

AssertionResult tangential() {
  const Needle needle =
      drive(tissue::one_surface(),
            down_to(0.002, [](double s) { return Vector3d(std::min(0.02, 0.02 * s), 0.0, 0.0); }), 2.0, 0.2);
  return all_of({steady(needle), below_N("sideways", needle.most_sideways_N, 0.6 * 0.6 * 1.3),
                 above("it still rests on the skin", needle.last_N, 0.3, 1.0, "N"),
                 below_N("no puncture", needle.most_N, 1.2)});
}

/// Straight down on each corner and each middle of an edge of one triangle.
AssertionResult edge_and_vertex() {
  const tissue::SurfaceMesh mesh = tissue::lattice_disc(0.03, 0.005);
  const auto& corners = mesh.triangles()[mesh.triangles().size() / 2];
  double least_N = 1e9;
  double most_N = 0.0;
  for (int k = 0; k < 6; ++k) {
    const Vector3d a = mesh.vertices()[corners[static_cast<std::size_t>(k % 3)]];
    const Vector3d b = mesh.vertices()[corners[static_cast<std::size_t>((k + 1) % 3)]];
    const Vector3d at = k < 3 ? a : Vector3d(0.5 * (a + b));
    tissue::Insertion run(tissue::one_surface(), at + Vector3d(0.0, 0.002, 0.0));
    double met_N = 0.0;
    for (int i = 0; i < 1000; ++i) {
      run.tick(run.needle.tip_m - Vector3d(0.0, 1e-5, 0.0));
      met_N = std::max(met_N, run.force_N.norm());
    }
    least_N = std::min(least_N, met_N);
    most_N = std::max(most_N, met_N);
  }
  return all_of({above("least", least_N, 1.49, 1.0, "N"), below_N("most force of a puncture at 1.5 N", most_N, 1.52)});
}

AssertionResult at_the_threshold() {
  tissue::Insertion run(tissue::one_surface(1.5), {0.0, 0.001, 0.0});
  const auto whole = [&](double deep_m) {
    run.tick({0.0, -deep_m, 0.0});
    return run.force_N.y();
  };
  (void)whole(0.001);
  double deep_m = 0.001;  // bisect the depth at which the force is the threshold, without passing it
  double step_m = 0.005;
  for (int i = 0; i < 60; ++i, step_m *= 0.5) {
    tissue::Insertion probe = run;
    probe.tick({0.0, -deep_m - step_m, 0.0});
    if (probe.tissue.layer(0).state == LayerState::Touching) deep_m += step_m;
  }
  const double first_N = whole(deep_m);
  bool still = true;
  for (int i = 0; i < 4000; ++i) still = still && whole(deep_m) == first_N;
  const bool touching = run.tissue.layer(0).state == LayerState::Touching;
  (void)whole(deep_m + 1e-7);
  return all_of({below_N("from the threshold", 1.5 - first_N, 1e-9),
                 {still && touching, "the force stays for 2 s"},
                 {run.tissue.layer(0).state == LayerState::Inserted, "0.1 um more punctures"}});
}

/// Through the controller, both nets push with their whole force, and both are punctured: at the end the two holes
/// drag, and no net pushes. The order of the punctures is checked on a tissue without the controller.
AssertionResult two_at_once() {
  tissue::TissueSettings two = tissue::one_surface(1.0, 0.1);
  two.layers.push_back(two.layers[0]);
  two.layers[0].name = "outer";
  two.layers[1].name = "inner";
  two.layers[1].top_m = 1e-6;
  const Needle needle = drive(two, down_to(0.012, [](double) { return Vector3d(0.0, 0.0, 0.0); }), 1.5);
  tissue::Insertion run(two);
  bool in_order = true;
  double both_N = 0.0;
  for (int i = 0; i < 2000; ++i) {
    run.tick(run.needle.tip_m - Vector3d(0.0, 1e-5, 0.0));
    both_N = std::max(both_N, run.force_N.norm());
    in_order = in_order &&
               (run.tissue.layer(1).state != LayerState::Inserted || run.tissue.layer(0).state == LayerState::Inserted);
  }
  return all_of({steady(needle),
                 above("both push on the hand", needle.most_N, 1.8, 1.0, "N"),
                 below_N("then both holes drag", needle.last_N, 0.21),
                 above("both push", both_N, 1.8, 1.0, "N"),
                 {in_order && run.tissue.layer(1).state == LayerState::Inserted, "the outer one is punctured first"},
                 below_N("then friction alone", run.force_N.norm(), 0.21)});
}

/// S4's law as printed drops the spring's force in the tick in which it slips, and the limiter spreads this over ticks.
AssertionResult as_printed() {
  constexpr double kLegs_s = 1.0;
  const auto in_steps = [](double s) {  // 6 mm in 0.3 s, then a rest of 0.7 s, seven times
    const double legs = std::floor(s / kLegs_s);
    return Vector3d(0.0, 0.001 - 0.006 * (std::min(legs, 7.0) + (legs < 7.0 ? std::min(1.0, (s - legs) / 0.3) : 0.0)),
                    0.0);
  };
  const Needle needle = drive(tissue::three_layers(1.0, tissue::BulkLaw::Paper), in_steps, 8.0);
  tissue::Insertion run(tissue::three_layers(1.0, tissue::BulkLaw::Paper));
  double slips = 0.0;
  for (int i = 0; i < 16'000; ++i) {
    const double before_N = run.force_N.y();
    run.tick(in_steps(i * kTick_s));
    if (before_N - run.force_N.y() > 0.2) ++slips;
  }
  Claim bounded = below_N("step", needle.felt.worst_step_N, kTick_N + 0.05);
  bounded.holds = bounded.holds && needle.felt.finite && !needle.felt.faulted;
  return all_of({bounded, below_mJ("ledger", needle.ledger_J, 0.1),
                 above("sticks after a rest, and slips", slips, 3.0, 1.0, "times")});
}

AssertionResult thinner_than_a_tick() {
  tissue::TissueSettings thin = tissue::one_surface(1.0, 0.2);
  thin.layers.push_back({.name = "film",
                         .top_m = 0.01,
                         .thickness_m = 2e-5,
                         .surface = tissue::SurfaceSettings{.punctures_at_N = 0.5, .friction_N = 0.1},
                         .bulk = tissue::BulkSettings{.slips_at_N = 0.1, .cuts_at_N = 0.3},
                         .relaxation = {}});
  tissue::Insertion run(thin);
  double film_N = 0.0;
  for (int i = 0; i < 400; ++i) {
    run.tick(run.needle.tip_m - Vector3d(0.0, 1e-4, 0.0));  // 0.2 m/s: five times the film's thickness
    film_N = std::max(film_N, run.tissue.layer(1).force_N.norm());
  }
  return all_of({above("the film is met", film_N, 0.45, 1.0, "N"),
                 {run.tissue.layer(1).state == LayerState::Inserted, "and punctured"},
                 {run.worst_gain_J <= 1e-12, "no energy gained"}});
}

/// The tissue begins 10 mm below the skin, so that the needle leaves it without leaving the body.
AssertionResult in_again() {
  tissue::TissueSettings below = tissue::one_surface(2.0);
  below.at_m.y() = -0.01;
  const auto twice = [](double s) {
    return Vector3d(0.0, -0.02 + 0.015 * std::cos(std::numbers::pi * s), 0.0);  // 5 to 35 mm deep, every 2 s
  };
  const Needle first = drive(below, twice, 1.2);
  const Needle again = drive(below, twice, 6.0, 2.0);
  return all_of({steady(first), steady(again), above("first", first.most_N, 1.9, 1.0, "N"),
                 above("later the hole's friction", again.most_N, 0.25, 1.0, "N"),
                 below_N("and no more", again.most_N, 0.45)});
}

AssertionResult from_inside() {
  tissue::Insertion run(tissue::one_surface(1.0, 0.1), {0.0, -0.03, 0.0});
  double most_N = 0.0;
  double against_N = 0.0;
  while (run.needle.tip_m.y() < 0.02) {
    run.tick(run.needle.tip_m + Vector3d(0.0, 1e-5, 0.0));
    most_N = std::max(most_N, run.force_N.norm());
    against_N = std::max(against_N, run.force_N.y());  // along the motion
  }
  return all_of({above("ruptures", most_N, 0.99, 1.0, "N"),
                 below_N("and never above", most_N, 1.02),
                 below_N("along the motion", against_N, 0.01),
                 {run.worst_gain_J <= 0.0, "no energy gained"},
                 {run.tissue.punctured(0), "it has a hole"}});
}

/// A disc whose triangles nearer than 8 mm to its middle are left out.
std::shared_ptr<const tissue::SurfaceMesh> disc_with_a_hole() {
  const tissue::SurfaceMesh whole = tissue::lattice_disc(0.03, 0.005);
  std::vector<Vector3d> vertices;
  std::vector<tissue::Triangle> triangles;
  std::map<std::uint32_t, std::uint32_t> kept;
  for (tissue::Triangle triangle : whole.triangles()) {
    if (std::ranges::any_of(triangle, [&](std::uint32_t v) { return whole.vertices()[v].norm() < 0.008; })) continue;
    for (std::uint32_t& v : triangle) {
      const auto [at, fresh] = kept.try_emplace(v, static_cast<std::uint32_t>(vertices.size()));
      if (fresh) vertices.push_back(whole.vertices()[v]);
      v = at->second;
    }
    triangles.push_back(triangle);
  }
  return std::make_shared<const tissue::SurfaceMesh>(*tissue::make_mesh(vertices, triangles));
}

/// The edge of the hole is part of the mesh's rim. The needle goes through the hole, sideways below the mesh, and up
/// through the mesh; another one goes down through the mesh.
AssertionResult mesh_with_a_hole() {
  tissue::TissueSettings net = tissue::one_surface(1.5, 0.3);
  net.mesh = disc_with_a_hole();
  tissue::Insertion through(net, {0.0, 0.005, 0.0});
  double in_hole_N = 0.0;
  const auto follow = [&](const Vector3d& way_m, double& most_N) {
    for (int i = 0; i < 1000; ++i) {
      through.tick(through.needle.tip_m + way_m / 1000);
      most_N = std::max(most_N, through.force_N.norm());
    }
  };
  follow({0.0, -0.015, 0.0}, in_hole_N);
  follow({0.018, 0.0, 0.0}, in_hole_N);
  double from_below_N = 0.0;
  follow({0.0, 0.03, 0.0}, from_below_N);
  tissue::Insertion beside(net, {0.018, 0.005, 0.0});
  double from_above_N = 0.0;
  for (int i = 0; i < 2000; ++i) {
    beside.tick(beside.needle.tip_m - Vector3d(0.0, 1e-5, 0.0));
    from_above_N = std::max(from_above_N, beside.force_N.norm());
  }
  return all_of({below_N("in the hole and below the mesh", in_hole_N, 1e-12),
                 above("ruptures from below", from_below_N, 1.4, 1.0, "N"),
                 below_N("at its threshold", from_below_N, 1.6),
                 above("ruptures from above", from_above_N, 1.4, 1.0, "N"),
                 below_N("at its threshold", from_above_N, 1.6),
                 {through.worst_gain_J <= 1e-12 && beside.worst_gain_J <= 1e-12, "no energy gained"}});
}

}  // namespace

std::vector<HardCase> needle_rows() {
  return {
      {"a needle drawn along the skin", "it is tangential to the net", "it slides, and never sticks or jumps",
       tangential},
      {"through an edge and a vertex", "the contact belongs to several triangles", "the same puncture as elsewhere",
       edge_and_vertex},
      {"stopped exactly at a threshold", "rounding could puncture or chatter",
       "the force stays, and 0.1 um more punctures", at_the_threshold},
      {"two layers at one place", "both are touched in one tick", "both push the hand, the outer one gives way first",
       two_at_once},
      {"S4's muscle as printed", "it slips in one tick, and sticks when coordinates repeat",
       "the limiter spreads the step, and it sticks after each rest", as_printed},
      {"a layer thinner than a tick's way", "the tip is through it in one tick", "it is met and punctured",
       thinner_than_a_tick},
      {"withdrawn and put in again", "a second rupture would be wrong", "the hole is felt, not the skin", in_again},
      {"a sac ruptured from inside", "the contact begins inside", "it holds against the motion, then ruptures",
       from_inside},
      {"a mesh with a hole", "a walk ends at the hole, whose edge is a rim", "free in the hole, whole beside it",
       mesh_with_a_hole},
  };
}

}  // namespace telepalp::hard_cases
