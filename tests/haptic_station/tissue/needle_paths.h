#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "haptic_station/device/random.h"
#include "haptic_station/tissue/layered_tissue.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::tissue {

/// Skin, muscle and sac, `stiff` times as stiff as usual.
inline TissueSettings three_layers(double stiff = 1.0, BulkLaw law = BulkLaw::Bristle) {
  TissueSettings tissue;
  tissue.net_edge_m = 0.005;
  Relaxation relaxes{.branches = 2, .share = {0.2, 0.3}, .time_s = {0.1, 1.0}};
  const SurfaceSettings skin{.stiffness_N_per_m = 300 * stiff,
                             .stiffening_N_per_m2 = 20000 * stiff,
                             .punctures_at_N = 2.5,
                             .friction_N = 0.3,
                             .bristle_N_per_m = 1000 * stiff};
  const SurfaceSettings sac{
      .stiffness_N_per_m = 150 * stiff, .punctures_at_N = 0.8, .friction_N = 0.1, .bristle_N_per_m = 1000 * stiff};
  const BulkSettings muscle{
      .law = law, .stick_N_per_m = 1000 * stiff, .slips_at_N = 0.4, .slips_at_N_per_m = 11.0, .cuts_at_N = 0.3};
  tissue.layers = {
      {.name = "skin", .thickness_m = 0.003, .surface = skin, .bulk = {}, .relaxation = relaxes},
      {.name = "muscle", .top_m = 0.003, .thickness_m = 0.03, .surface = {}, .bulk = muscle, .relaxation = relaxes},
      {.name = "sac", .top_m = 0.035, .surface = sac, .bulk = {}, .relaxation = relaxes}};
  tissue.shaft = {.side_N_per_m = 200 * stiff, .tears_at_N_per_m = 30.0, .bevel_rad = 0.2};
  return tissue;
}

/// One surface of 300 N/m that is punctured at `at_N`, without relaxation.
inline TissueSettings one_surface(double at_N = 1.5, double friction_N = 0.3) {
  TissueSettings tissue;
  tissue.net_edge_m = 0.005;
  tissue.layers = {{.name = "skin",
                    .surface = SurfaceSettings{.punctures_at_N = at_N, .friction_N = friction_N},
                    .bulk = {},
                    .relaxation = {}}};
  return tissue;
}

/// A needle that is moved through a tissue in small steps, with the sums that a hand would feel.
class Insertion {
 public:
  explicit Insertion(const TissueSettings& settings, const Eigen::Vector3d& from_m = {0.0, 0.005, 0.0})
      : tissue(*make_tissue(settings)) {
    needle.tip_m = from_m;
    tissue.begin(needle);
  }
  void tick(const Eigen::Vector3d& to_m) {
    const Eigen::Vector3d by_m = to_m - needle.tip_m;
    const double stiffness = tissue.stiffness_N_per_m();
    const bool fell = tissue.falls();
    std::vector<LayerState> before;
    for (std::size_t i = 0; i < tissue.size(); ++i) before.push_back(tissue.layer(i).state);
    needle.tip_m = to_m;
    const Eigen::Vector3d now_N = tissue.step(needle, kTick_s).force_N;
    bool changed = fell || tissue.falls();
    for (std::size_t i = 0; i < tissue.size(); ++i) changed = changed || tissue.layer(i).state != before[i];
    const double beyond_N = (now_N - force_N).norm() - std::max(stiffness, tissue.stiffness_N_per_m()) * by_m.norm();
    if (!changed) worst_step_N = std::max(worst_step_N, beyond_N);
    taken_J += -0.5 * (now_N + force_N).dot(by_m);
    held_J += -force_N.dot(by_m);
    force_N = now_N;
    worst_gain_J = std::max(worst_gain_J, tissue.stored_J() - taken_J);
  }
  void move(const Eigen::Vector3d& to_m, double speed_m_per_s = 0.02) {
    const Eigen::Vector3d from_m = needle.tip_m;
    const int ticks = std::max(1, static_cast<int>(std::ceil((to_m - from_m).norm() / (speed_m_per_s * kTick_s))));
    for (int i = 1; i <= ticks; ++i) tick(from_m + (to_m - from_m) * i / ticks);
  }
  void rest(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kTick_s)); ++i) tick(needle.tip_m);
  }

  LayeredTissue tissue;
  NeedleMotion needle;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  double taken_J = 0.0;       ///< work of the hand, by the mean of each tick's two forces
  double held_J = 0.0;        ///< work of the hand, by the force that is held over each tick
  double worst_gain_J = 0.0;  ///< the most by which stored energy exceeded taken_J
  double worst_step_N = 0.0;  ///< |change of force| - stiffness × |motion|, outside rupture and slip
};

/// A needle that has just punctured `given`, a surface alone and without friction. It comes from `above_m` and goes
/// straight down at 20 mm/s.
inline Insertion just_punctured(const SurfaceSettings& given, const Eigen::Vector3d& above_m) {
  TissueSettings one = one_surface();
  one.layers[0].surface = given;
  one.layers[0].surface->friction_N = 0.0;
  Insertion run(one);
  for (Eigen::Vector3d to_m = above_m; run.tissue.layer(0).state != LayerState::Inserted;)
    run.tick(to_m -= Eigen::Vector3d(0.0, 1e-5, 0.0));
  return run;
}

/// A tip that wanders through all layers, from rest to 0.1 m/s, with rests.
class Wanderer {
 public:
  Wanderer(const Eigen::Vector3d& from_m, std::uint64_t seed) : random_(seed), at_m_(from_m), goal_m_(from_m) {}
  /// The place at the next tick.
  Eigen::Vector3d next() {
    if ((goal_m_ - at_m_).norm() < 1e-4 || random_.uniform() < 0.0005) {
      goal_m_ = {random_.uniform(-0.012, 0.012), random_.uniform(-0.06, 0.01), random_.uniform(-0.012, 0.012)};
      speed_m_per_s_ = random_.uniform() < 0.2 ? 0.0 : 0.005 * std::pow(20.0, random_.uniform());
    }
    const Eigen::Vector3d way_m = goal_m_ - at_m_;
    const double most_m = speed_m_per_s_ * kTick_s;
    at_m_ += way_m.norm() > most_m ? Eigen::Vector3d(way_m * (most_m / way_m.norm())) : way_m;
    return at_m_;
  }

 private:
  device::Random random_;
  Eigen::Vector3d at_m_;
  Eigen::Vector3d goal_m_;
  double speed_m_per_s_ = 0.02;
};

inline void wander(Insertion& run, int ticks, std::uint64_t seed) {
  Wanderer tip(run.needle.tip_m, seed);
  for (int i = 0; i < ticks; ++i) run.tick(tip.next());
}

}  // namespace telepalp::tissue
