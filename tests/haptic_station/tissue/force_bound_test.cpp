#include "haptic_station/tissue/force_bound.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

/// Two to four nets within 15 mm, some of which relax.
TissueSettings close_nets(device::Random& random) {
  TissueSettings tissue = one_surface();
  tissue.net_edge_m = 0.0075;
  tissue.layers.clear();
  double top_m = 0.0;
  const int count = 2 + static_cast<int>(random.bits() % 3);
  for (int i = 0; i < count; ++i) {
    LayerSettings layer{.name = "net", .top_m = top_m, .surface = SurfaceSettings{}, .bulk = {}, .relaxation = {}};
    layer.surface->stiffness_N_per_m = random.uniform(100.0, 400.0);
    layer.surface->stiffening_N_per_m2 = random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 15000.0);
    layer.surface->punctures_at_N = random.uniform(0.5, 2.5);
    layer.surface->side_grip = random.uniform(0.2, 0.8);
    if (random.uniform() < 0.5) layer.relaxation = {.branches = 2, .share = {0.3, 0.2}, .time_s = {0.1, 2.0}};
    tissue.layers.push_back(layer);
    top_m += random.uniform(0.0, 0.005);
  }
  return tissue;
}

/// The needle goes out and in again, straight and slanting, at 5 to 20 mm/s. At these speeds the force exceeds a
/// puncture by a few hundredths of a newton within one tick.
TEST(ForceBound, NoSlowNeedleFeelsMoreInNetsThatLieCloseTogether) {
  constexpr std::uint64_t kSeed = 7;
  constexpr double kOvershoot_N = 0.05;
  device::Random random(kSeed);
  double closest = 0.0;
  for (int tissue = 0; tissue < 30; ++tissue) {
    Insertion run(close_nets(random));
    const double most_N = run.tissue.most_N();
    double felt_N = 0.0;
    const auto go = [&](const Vector3d& to_m) {
      const Vector3d by_m = (to_m - run.needle.tip_m) / 3000.0;
      for (int i = 0; i < 3000; ++i) {
        run.tick(run.needle.tip_m + by_m);
        felt_N = std::max(felt_N, run.force_N.norm());
      }
    };
    for (int leg = 0; leg < 4; ++leg) {
      const double x_m = random.uniform(-0.008, 0.008);
      go({x_m, 0.002, 0.0});
      go({x_m + random.uniform(-0.004, 0.004), -0.025, random.uniform(-0.004, 0.004)});
    }
    EXPECT_LE(felt_N, most_N + kOvershoot_N) << "seed " << kSeed << ", tissue " << tissue;
    closest = std::max(closest, felt_N / most_N);
  }
  EXPECT_GT(closest, 0.7) << "the bound is not far from what a needle feels";
}

TEST(ForceBound, CountsTheNetsThatATipReachesTogetherAndNoOthers) {
  TissueSettings tissue = one_surface(1.0, 0.0);
  const StiffnessRange even{1.0, 1.0};
  EXPECT_DOUBLE_EQ(most_force_N(tissue, even), 1.0);
  tissue.layers[0].surface->side_grip = 0.0;
  tissue.layers.push_back(tissue.layers[0]);
  EXPECT_NEAR(most_force_N(tissue, even), 2.0, 1e-12) << "at one place, both push until the outer one is punctured";
  tissue.layers[1].top_m = 0.0025;
  EXPECT_NEAR(most_force_N(tissue, even), 1.25, 1e-12) << "the outer one bends by 3.3 mm";
  tissue.layers[1].top_m = 0.004;
  EXPECT_NEAR(most_force_N(tissue, even), 1.0, 1e-12) << "the tip reaches the inner one only through the outer one";
  tissue.layers[0].relaxation = {.branches = 1, .share = {0.5}, .time_s = {0.1}};
  EXPECT_NEAR(most_force_N(tissue, even), 1.0 + 300.0 * (2.0 / 300.0 - 0.004), 1e-12) << "relaxed, it bends by 6.7 mm";
  tissue.layers[0].relaxation.share[0] = 1.0;
  EXPECT_GT(most_force_N(tissue, even), 50.0) << "a slow tip never punctures a net whose force relaxes to zero";
}

}  // namespace
}  // namespace telepalp::tissue
