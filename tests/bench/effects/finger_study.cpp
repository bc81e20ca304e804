#include "tests/bench/effects/finger_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/effects/tissue_presets.h"
#include "haptic_station/solids/polish.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;

constexpr double kTick_s = 0.0005;
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

RibCount count_ribs(const scenes::Scene& scene, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  const double side = uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  const double x = side * uniform(0.025, 0.045);
  const double depth_m = 0.0155 + 0.5 * x * x / 0.13 + uniform(0.0, 0.002);  // a third of a rib's width deep in it
  const double speed = uniform(0.02, 0.04);
  const Tremor tremor(random);
  std::normal_distribution<double> noise(0.0, kNoise_N);
  effects::EffectBank bank = scene.effects;
  std::vector<Vector3d> path;
  std::vector<double> trace_N;
  RibCount count;
  constexpr double kWay_m = 0.2;
  Vector3d last_N = Vector3d::Zero();
  double smooth_N = 0.0;
  const int ticks = static_cast<int>(kWay_m / speed / kTick_s);
  for (int i = 0; i < ticks; ++i) {
    const double t = i * kTick_s;
    const double pressed_m = depth_m * std::min({1.0, t / 0.5, (ticks - i) * kTick_s / 0.5});
    path.emplace_back(x + tremor.at_m(t, 0), -pressed_m + tremor.at_m(t, 1),
                      -0.5 * kWay_m + speed * t + tremor.at_m(t, 2));
    effects::EffectInput in = under_skin(path.back());
    if (i == 0) bank.begin(in);
    const Vector3d now_N = bank.step(in, kTick_s).N;
    if (i > 0) count.worst_step_N = std::max(count.worst_step_N, (now_N - last_N).norm());
    last_N = now_N;
    smooth_N += 0.01 * (now_N.y() + noise(random) - smooth_N);
    trace_N.push_back(smooth_N);
  }
  count.crossed = entries_of(*scene.layers.front()->tree, path);
  count.counted = peaks_of(trace_N, 0.5);
  return count;
}

bool finds_mass(const Mass& mass, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  const Vector3d at(uniform(-0.035, 0.035), -mass.depth_m - 0.5 * mass.size_m, uniform(-0.035, 0.035));
  const Tremor tremor(random);
  const std::string text = "tr " + std::to_string(at.x()) + " " + std::to_string(at.y()) + " " +
                           std::to_string(at.z()) + " sphere " + std::to_string(0.5 * mass.size_m);
  const auto tree = *solids::build_tree(*solids::parse_polish(text, "mass"));
  effects::EffectBank bank;
  (void)bank.add(effects::Skin({.law = effects::find_tissue("relaxed_belly")->law}));
  (void)bank.add(
      effects::Solid({.layer = std::make_shared<const effects::SolidLayer>(effects::SolidLayer{"mass", tree, {}}),
                      .stiffness_N_per_m = mass.stiffness_N_per_m}));
  constexpr double kPress_N = 8.0;
  std::normal_distribution<double> noise(0.0, kNoise_N);
  std::vector<std::pair<double, Vector3d>> reached;  // depth, place
  for (double x = -0.045; x <= 0.0451; x += 0.015)
    for (double z = -0.045; z <= 0.0451; z += 0.015) {
      double depth_m = 0.0;
      double felt_N = 0.0;
      for (int i = 0; i < 4000 && felt_N < kPress_N && depth_m < 0.06; ++i) {
        const double t = i * kTick_s;
        depth_m = 0.03 * t;
        effects::EffectInput in = under_skin({x + tremor.at_m(t, 0), -depth_m, z + tremor.at_m(t, 2)});
        if (i == 0) bank.begin(in);
        felt_N = bank.step(in, kTick_s).N.norm() + noise(random);
      }
      reached.emplace_back(depth_m, Vector3d(x, 0.0, z));
    }
  std::vector<double> depths;
  for (const auto& [depth_m, place] : reached) depths.push_back(depth_m);
  std::nth_element(depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2), depths.end());
  const double usual_m = depths[depths.size() / 2];
  const auto& [least_m, place] = *std::ranges::min_element(reached, {}, [](const auto& one) { return one.first; });
  const double off_m = std::hypot(place.x() - at.x(), place.z() - at.z());
  return least_m < usual_m - 0.0015 && off_m < 0.015;
}

}  // namespace telepalp::bench
