#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "haptic_station/solids/distance_lattice.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/forced_path.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using Eigen::Vector3d;
using ::testing::AssertionResult;

/// A ball of 25 mm, its middle 55 mm deep, as an organ's shape.
std::shared_ptr<const solids::DistanceLattice> ball() {
  constexpr int kNodes = 40;
  const Vector3d center_m{0.0, -0.055, 0.0};
  auto lattice = std::make_shared<solids::DistanceLattice>();
  lattice->spacing_m = 0.002;
  lattice->size = {kNodes, kNodes, kNodes};
  lattice->origin_m = center_m - Vector3d::Constant(0.5 * lattice->spacing_m * (kNodes - 1));
  for (int k = 0; k < kNodes; ++k)
    for (int j = 0; j < kNodes; ++j)
      for (int i = 0; i < kNodes; ++i)
        lattice->nodes_m.push_back(
            static_cast<float>((lattice->origin_m + lattice->spacing_m * Vector3d(i, j, k) - center_m).norm() - 0.025));
  return lattice;
}

/// The skin, and one object of 800 N/m whose top lies 30 mm under it.
std::array<effects::EffectBank, 3> skins_with_an_object() {
  std::array<effects::EffectBank, 3> banks;
  for (effects::EffectBank& bank : banks) (void)bank.add(effects::Skin({.law = effects::linear_law(20.0)}));
  (void)banks[0].add(effects::InnerSphere({.center = {{0.0, -0.05, 0.0}}}));
  (void)banks[1].add(effects::InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}));
  (void)banks[2].add(effects::Organ({.shape = ball(), .stiffness_N_per_m = 800.0}));
  return banks;
}

/// A hand that nothing stops goes along `path`, from `from_s` on against `push`. The skin is soft, so that it does not
/// hide what the objects do.
AssertionResult forced_through(const std::function<Vector3d(double)>& path, const Vector3d& push, double from_s) {
  double least_N = 1e9;
  double most_N = 0.0;
  double step_N = 0.0;
  for (const effects::EffectBank& bank : skins_with_an_object()) {
    ForcedPath scene{.seconds = ForcedPath::kDown_s + 4.0, .effects = bank, .path = path};
    double met_N = 0.0;
    scene.watch = [&](const control::ControlOutput& out, double now_s) {
      if (now_s < ForcedPath::kDown_s + from_s) return;
      least_N = std::min(least_N, -out.force.N.dot(push));
      met_N = std::max(met_N, out.force.N.norm());
    };
    step_N = std::max(step_N, feel(scene).worst_step_N);
    most_N = most_N == 0.0 ? met_N : std::min(most_N, met_N);
  }
  return all_of({above("least force against the push", least_N, -0.02, 1.0, "N"),
                 above("each object is felt", most_N, 5.0, 1.0, "N"), below_N("step", step_N, kTick_N)});
}

AssertionResult pushed_through() {
  for (const double beside_m : {0.0, 0.004, 0.01}) {
    const AssertionResult got = forced_through(
        [=](double s) { return Vector3d(beside_m, std::max(-0.085, -0.03 * s), 0.0); }, -Vector3d::UnitY(), 0.3);
    if (!got || beside_m == 0.01) return got;
  }
  return ::testing::AssertionFailure();
}

/// The hand digs in 60 mm beside the object, and is drawn through it.
AssertionResult pushed_through_sideways() {
  return forced_through(
      [](double s) {
        return Vector3d(0.06 - std::clamp(0.04 * (s - 1.0), 0.0, 0.12), -0.052 * std::min(1.0, s), 0.001);
      },
      -Vector3d::UnitX(), 1.0);
}

/// A hand pushes with 4.5 N without end. The motors get warm, the force yields slowly, and the hand sinks past the
/// object, in minutes. It may be held less, but never drawn down.
AssertionResult warm_motors() {
  double least_N = 1e9;
  double least_deep_m = 1e9;
  double fastest = 0.0;
  for (const effects::EffectBank& bank : skins_with_an_object()) {
    double deepest_m = 0.0;
    ControllerScene scene;
    scene.seconds = 90.0;
    scene.settings.effects = bank;
    scene.person = [&](const device::TrialView& view) {
      constexpr double kPush_N = 4.5;
      if (view.time_s < 1.5) return presses_to(0.02)(view);
      const double ahead_m = kPush_N / device::SimulatedHandSettings{}.stiffness_N_per_m;
      return device::Intention{{{0.002, std::max(-0.1, view.device.m.y()) - ahead_m, 0.0}}, {}};
    };
    bool held = false;
    scene.watch = [&](const control::ControlOutput& out, double now_s) {
      held = held || (now_s > 1.8 && out.force.N.y() > 3.5);
      const bool through = deepest_m > 0.082;  // behind the far face, the hand may come up again
      if (!held || through || !control::is_inside(out.phase)) return;
      least_N = std::min(least_N, out.force.N.y());
      deepest_m = std::max(deepest_m, -out.target.m.y());
    };
    fastest = std::max(fastest, feel(scene).fastest_device);
    least_deep_m = std::min(least_deep_m, deepest_m);
  }
  return all_of({above("it sinks past the middle", least_deep_m, 0.06, 1e3, "mm"),
                 above("least force against the push", least_N, 0.0, 1.0, "N"),
                 below("fastest", fastest, 1.0, 1.0, "m/s")});
}

/// Two membranes, 10 and 20 mm deep, that each halve the skin's stiffness when they tear. The hand goes through both,
/// comes out to 5 mm, and goes in again.
AssertionResult two_that_weaken_the_skin() {
  const auto halves = [](double y_m) {
    return effects::Membrane({.at = {{0.0, y_m, 0.0}}, .tears_at_N = 1.0, .friction_N = 0.2, .skin_left = 0.5});
  };
  effects::EffectBank bank;
  (void)bank.add(effects::Skin({.law = effects::linear_law(100.0)}));
  (void)bank.add(halves(-0.01));
  (void)bank.add(halves(-0.02));
  ForcedPath scene{.seconds = ForcedPath::kDown_s + 4.0, .effects = bank, .path = [](double s) {
                     return Vector3d(0.0, -0.0175 + 0.0175 * std::cos(std::numbers::pi * s) - 0.005, 0.0);
                   }};
  double least_balance_J = 0.0;
  double last_N = 0.0;
  scene.watch = [&](const control::ControlOutput& out, double) {
    least_balance_J = std::min(least_balance_J, out.passivity_J);
    last_N = out.force.N.y();
  };
  const Felt felt = feel(scene);
  return all_of({below_N("step", felt.worst_step_N, kTick_N),
                 below_mJ("the ledger's error", -least_balance_J, 0.1),
                 {std::abs(last_N - 0.25 * 100.0 * 0.005) < 0.01, "a quarter of the skin is left at the end"},
                 {felt.finite && !felt.faulted, "no fault"}});
}

}  // namespace

std::vector<HardCase> inner_rows() {
  return {
      {"pushed down through an object", "the nearest face is the far one", "no pull along the push", pushed_through},
      {"pushed sideways through an object", "it was entered from its side", "no pull along the push",
       pushed_through_sideways},
      {"two effects weaken the skin", "a skin that stiffens again would give energy", "it only gets weaker",
       two_that_weaken_the_skin},
      {"4.5 N held on an object for 90 s", "warm motors yield, the hand sinks past it", "no pull along the push",
       warm_motors},
  };
}

}  // namespace telepalp::hard_cases
