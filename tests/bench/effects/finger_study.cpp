#include "tests/bench/effects/finger_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/effects/presets/tissue_presets.h"
#include "haptic_station/solids/polish.h"
#include "proto/words/numbers/quantile.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;

constexpr double kNoise_N = 0.02;

/// The sum of two slow sines: a hand's tremor, 0.3 mm.
class Tremor {
 public:
  explicit Tremor(std::mt19937_64& random) {
    std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
    for (double& one : phases_) one = phase(random);
  }
  [[nodiscard]] double at_m(double time_s, std::size_t axis) const {
    return 2e-4 * std::sin(2.0 * std::numbers::pi * 7.0 * time_s + phases_[axis]) +
           1e-4 * std::sin(2.0 * std::numbers::pi * 2.3 * time_s + phases_[axis + 2]);
  }

 private:
  std::array<double, 5> phases_{};
};

effects::EffectInput under_skin(const Vector3d& at) {
  effects::EffectInput in;
  in.device.m = at;
  in.contact = device::BreathingPlane{}(in.device, 0.0);
  return in;
}

/// Peaks of a trace that rise and fall by at least `swing_N`.
int peaks_of(const std::vector<double>& trace_N, double swing_N) {
  int peaks = 0;
  double low = trace_N.front();
  double high = trace_N.front();
  bool rising = true;
  for (const double now : trace_N) {
    high = std::max(high, now);
    low = std::min(low, now);
    if (rising && now < high - swing_N) {
      ++peaks;
      rising = false;
      low = now;
    } else if (!rising && now > low + swing_N) {
      rising = true;
      high = now;
    }
  }
  return peaks;
}

/// Intervals of the path in which it is inside a layer.
int entries_of(const solids::SolidTree& tree, const std::vector<Vector3d>& path) {
  int entries = 0;
  bool inside = false;
  for (const Vector3d& p : path) {
    const bool now = solids::solid_at(tree, p).m < 0.0;
    entries += now && !inside ? 1 : 0;
    inside = now;
  }
  return entries;
}

}  // namespace

namespace {

/// Presses down at rest, slides along z at one depth, and lifts at rest.
class ChestPath {
 public:
  ChestPath(const solids::SolidTree& ribs, std::mt19937_64& random) {
    const auto uniform = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
    const double side = uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    x_m_ = side * uniform(0.025, 0.045);
    depth_m_ = 0.0155 + 0.5 * x_m_ * x_m_ / 0.13 + uniform(0.0, 0.002);  // 3.5 to 5.5 mm below the top of a rib
    speed_m_per_s_ = uniform(0.02, 0.04);
    from_m_ = gap_after(ribs, uniform(-0.2, -0.1));
    to_m_ = gap_after(ribs, uniform(0.0, 0.1));
  }
  [[nodiscard]] double length_s() const { return 2.0 * kPress_s + (to_m_ - from_m_) / speed_m_per_s_; }
  [[nodiscard]] Vector3d at(double time_s) const {
    const double slid_m = speed_m_per_s_ * (std::min(time_s, length_s() - kPress_s) - kPress_s);
    const double pressed = std::min({1.0, time_s / kPress_s, (length_s() - time_s) / kPress_s});
    return {x_m_, -pressed * depth_m_, from_m_ + std::max(0.0, slid_m)};
  }

 private:
  static constexpr double kPress_s = 0.5;

  /// The next z that is 5 mm or more from each rib: the finger is set between two ribs [m].
  [[nodiscard]] double gap_after(const solids::SolidTree& ribs, double z_m) const {
    while (solids::solid_at(ribs, {x_m_, -depth_m_, z_m}).m < 0.005) z_m += 0.001;
    return z_m;
  }

  double x_m_, depth_m_, speed_m_per_s_, from_m_ = 0.0, to_m_ = 0.0;
};

/// Depth at which the effects push back with `force_N` at (x, z), at most 60 mm.
double depth_at_force(effects::EffectBank bank, double x, double z, double force_N, const Tremor& tremor,
                      std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, kNoise_N);
  double depth_m = 0.0;
  double felt_N = 0.0;
  for (int i = 0; i < 4000 && felt_N < force_N && depth_m < 0.06; ++i) {
    const double t = i * kTick_s;
    depth_m = std::max(0.0, 0.03 * t + tremor.at_m(t, 1));
    const effects::EffectInput in = under_skin({x + tremor.at_m(t, 0), -depth_m, z + tremor.at_m(t, 2)});
    if (i == 0) bank.begin(in);
    felt_N = bank.step(in, kTick_s).force.N.norm() + noise(random);
  }
  return depth_m;
}

effects::EffectBank belly_with(const std::optional<Mass>& mass, const Vector3d& at) {
  effects::EffectBank bank;
  (void)bank.add(effects::Skin({.law = effects::find_tissue("relaxed_belly")->law}));
  if (!mass) return bank;
  const std::string text = "tr " + std::to_string(at.x()) + " " + std::to_string(at.y()) + " " +
                           std::to_string(at.z()) + " sphere " + std::to_string(0.5 * mass->size_m);
  const auto tree = *solids::build_tree(*solids::parse_polish(text, "mass"));
  (void)bank.add(
      effects::Solid({.layer = std::make_shared<const effects::SolidLayer>(effects::SolidLayer{"mass", tree, {}}),
                      .stiffness_N_per_m = mass->stiffness_N_per_m,
                      .tip_radius_m = 0.008}));
  return bank;
}

}  // namespace

RibCount count_ribs(const scenes::Scene& scene, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const solids::SolidTree& ribs = *scene.layers().front().solid->tree;
  const ChestPath finger(ribs, random);
  const Tremor tremor(random);
  std::normal_distribution<double> noise(0.0, kNoise_N);
  effects::EffectBank bank = core::bank_of(scene.effects);
  std::vector<Vector3d> path;
  std::vector<double> trace_N;
  RibCount count;
  Vector3d last_N = Vector3d::Zero();
  double smooth_N = 0.0;
  const int ticks = static_cast<int>(finger.length_s() / kTick_s);
  for (int i = 0; i < ticks; ++i) {
    const double t = i * kTick_s;
    path.push_back(finger.at(t) + Vector3d(tremor.at_m(t, 0), tremor.at_m(t, 1), tremor.at_m(t, 2)));
    const effects::EffectInput in = under_skin(path.back());
    if (i == 0) bank.begin(in);
    const Vector3d now_N = bank.step(in, kTick_s).force.N;
    if (i > 0) count.worst_step_N = std::max(count.worst_step_N, (now_N - last_N).norm());
    last_N = now_N;
    smooth_N += 0.01 * (now_N.y() + noise(random) - smooth_N);
    trace_N.push_back(smooth_N);
  }
  count.crossed = entries_of(ribs, path);
  count.counted = peaks_of(trace_N, 0.5);
  return count;
}

MassSearch search_mass(const std::optional<Mass>& mass, std::uint64_t seed) {
  constexpr double kPress_N = 8.0;
  constexpr double kGrid_m = 0.01;
  constexpr double kShallower_m = 0.001;  // over a mass, depth is less by this: 10 times the scatter
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-0.035, 0.035);
  Vector3d at(place(random), 0.0, place(random));
  if (mass) at.y() = -mass->depth_m - 0.5 * mass->size_m;
  const Tremor tremor(random);
  const effects::EffectBank bank = belly_with(mass, at);
  MassSearch search;
  std::vector<std::pair<double, Vector3d>> reached;  // depth, place
  for (double x = -0.045; x <= 0.0451; x += kGrid_m)
    for (double z = -0.045; z <= 0.0451; z += kGrid_m) {
      reached.emplace_back(depth_at_force(bank, x, z, kPress_N, tremor, random), Vector3d(x, 0.0, z));
      search.hand_s += reached.back().first / 0.03 + 0.3;  // and 0.3 s to the next place
    }
  std::vector<double> depths;
  for (const auto& [depth_m, where] : reached) depths.push_back(depth_m);
  const double usual_m = median_of(depths);
  const auto& [least_m, where] = *std::ranges::min_element(reached, {}, [](const auto& one) { return one.first; });
  search.named = least_m < usual_m - kShallower_m;
  search.right = search.named && mass && std::hypot(where.x() - at.x(), where.z() - at.z()) < 0.015;
  return search;
}

}  // namespace telepalp::bench
