#include "tools/study/experiments/rib_task.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"

namespace telepalp::study {
namespace {

constexpr double kTick_s = 1.0 / 2000.0;
constexpr int kTicksPerSample = 20;
constexpr double kArm_kg = 0.5;          // van Beek 2015: 0.554 kg
constexpr double kArm_N_s_per_m = 20.0;  // keeps the finger from bouncing
constexpr double kArm_N_per_m = 300.0;   // along the slide; as the operators of the needle's study
constexpr std::size_t kLeastRibs = 6;
constexpr double kOneRib_m = 0.012;  // touch and sight within this distance speak of one rib

effects::EffectInput input_at(const Eigen::Vector3d& at, const Eigen::Vector3d& velocity) {
  effects::EffectInput in;
  in.device.m = at;
  in.device_velocity.v = velocity;
  in.moved.v = kTick_s * velocity;
  in.contact = {.proxy = {{at.x(), std::max(0.0, at.y()), at.z()}},
                .normal = {Eigen::Vector3d::UnitY()},
                .distance_m = at.y(),
                .in_body = at.y() < 0.0,
                .valid = true};
  return in;
}

/// Finds turns of a signal: a peak counts when the signal has fallen by `least` from it, after a rise by `least`.
class PeakFinder {
 public:
  explicit PeakFinder(double least) noexcept : least_(least) {}
  /// The place of a peak that has just been passed.
  [[nodiscard]] std::optional<double> next(double at, double value) noexcept {
    if (value < low_) low_ = value;
    if (value > high_) {
      high_ = value;
      high_at_ = at;
    }
    if (rises_ && high_ - value >= least_) {
      rises_ = false;
      low_ = value;
      return high_at_;
    }
    if (!rises_ && value - low_ >= least_) {
      rises_ = true;
      high_ = value;
      high_at_ = at;
    }
    return std::nullopt;
  }

 private:
  double least_;
  double low_ = 1e9, high_ = -1e9, high_at_ = 0.0;
  bool rises_ = false;
};

/// Places where the force along the slide has held the finger back and lets it go: a top is reached.
std::vector<double> felt_tops(const std::vector<SlideSample>& samples, double noise_N, double threshold_N,
                              device::Random& random) {
  std::vector<double> tops;
  bool held = false;
  double felt_N = 0.0;
  for (const SlideSample& sample : samples) {
    // The observer averages over about 0.1 s. White noise of noise_N sqrt(19) leaves noise_N in this average.
    felt_N += 0.1 * (sample.along_N + noise_N * std::sqrt(19.0) * random.normal() - felt_N);
    if (felt_N < -threshold_N) held = true;
    if (held && felt_N > 0.0) {
      held = false;
      tops.push_back(sample.z_m);
    }
  }
  return tops;
}

/// Tops of the finger's height, as it is felt or seen with this noise.
std::vector<double> height_tops(const std::vector<SlideSample>& samples, double noise_m, double threshold_m,
                                device::Random& random) {
  std::vector<double> tops;
  PeakFinder finder(threshold_m);
  double seen_m = samples.front().height_m;
  for (const SlideSample& sample : samples) {
    seen_m += 0.1 * (sample.height_m + noise_m * std::sqrt(19.0) * random.normal() - seen_m);
    if (const std::optional<double> top = finder.next(sample.z_m, seen_m)) tops.push_back(*top);
  }
  return tops;
}

/// One list of both: tops that lie within kOneRib_m of each other are one rib.
std::vector<double> merged(std::vector<double> one, const std::vector<double>& other) {
  one.insert(one.end(), other.begin(), other.end());
  std::sort(one.begin(), one.end());
  std::vector<double> out;
  for (const double top : one)
    if (out.empty() || top - out.back() > kOneRib_m) out.push_back(top);
  return out;
}

}  // namespace

std::vector<SlideSample> slide(const Chest& chest, double press_N, double speed_m_per_s, double from_m, double to_m,
                               double wobble_m, device::Random& random) {
  constexpr double kApproach_s = 0.6;  // the finger is pressed in before it slides
  effects::EffectBank effects = chest.effects;
  Eigen::Vector3d at(kSlideAt_m, 0.001, from_m), velocity = Eigen::Vector3d::Zero();
  const double tremor_rad_per_s = 2.0 * std::numbers::pi * random.uniform(6.0, 12.0);
  const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
  effects.begin(input_at(at, velocity));
  std::vector<SlideSample> samples;
  const double ends_s = kApproach_s + (to_m - from_m) / speed_m_per_s;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  for (int tick = 0; tick * kTick_s < ends_s; ++tick) {
    const double time_s = tick * kTick_s;
    const double slid_m = std::max(0.0, time_s - kApproach_s) * speed_m_per_s;
    const double tremor_m = std::numbers::sqrt2 * wobble_m * std::sin(tremor_rad_per_s * time_s + phase);
    const double push_N = press_N * std::min(1.0, time_s / (0.5 * kApproach_s));
    velocity.y() += kTick_s / kArm_kg * (force_N.y() - push_N - kArm_N_s_per_m * velocity.y());
    const double ahead_m = from_m + slid_m + tremor_m - at.z();
    velocity.z() += kTick_s / kArm_kg * (force_N.z() + kArm_N_per_m * ahead_m - kArm_N_s_per_m * velocity.z());
    at += kTick_s * velocity;
    force_N = effects.step(input_at(at, velocity), kTick_s).force.N;
    if (time_s >= kApproach_s && tick % kTicksPerSample == 0) samples.push_back({at.z(), at.y(), force_N.z()});
  }
  return samples;
}

Result<Chest> read_chest(const std::string& scene) {
  const Result<std::filesystem::path> file = scenes::find_scene(scene);
  if (!file) return file.error();
  const Result<scenes::Scene> read = scenes::read_scene(*file);
  if (!read) return read.error();
  Chest chest{.effects = core::bank_of(read->effects), .ribs_m = {}};
  device::Random still(1);
  PeakFinder finder(0.001);
  for (const SlideSample& sample : slide(chest, kFirmPress_N, 0.02, kChestFrom_m, kChestTo_m, 0.0, still))
    if (const std::optional<double> top = finder.next(sample.z_m, sample.height_m)) chest.ribs_m.push_back(*top);
  if (chest.ribs_m.size() < kLeastRibs)
    return Error{.what = "a slide along the chest passes " + std::to_string(chest.ribs_m.size()) + " ribs",
                 .where = file->string(),
                 .fix = "use the scene ribs-ultrasound as telepalp ships it"};
  return chest;
}

int counted_ribs(const RibCounter& person, const std::vector<SlideSample>& samples, double press_N, bool sees,
                 device::Random& random) {
  if (samples.empty()) return 0;
  const double noise_N = std::max(person.force_floor_N, person.force_jnd * press_N);
  const auto by_height = [&](double noise_m) {
    return height_tops(samples, noise_m, person.caution * noise_m, random);
  };
  std::vector<double> tops =
      merged(felt_tops(samples, noise_N, person.caution * noise_N, random), by_height(person.height_m));
  if (sees) tops = merged(std::move(tops), by_height(person.sight_m));
  int counted = 0;
  for (std::size_t i = 0; i < tops.size(); ++i) counted += random.uniform() < person.lapses ? 0 : 1;
  return counted;
}

}  // namespace telepalp::study
