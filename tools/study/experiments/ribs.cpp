#include "tools/study/experiments/ribs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"
#include "proto/words/numbers/fixed_text.h"

namespace telepalp::study {
namespace {

constexpr double kTick_s = 1.0 / 2000.0;
constexpr int kTicksPerSample = 20;
constexpr double kArm_kg = 0.5;                  // van Beek 2015: 0.554 kg
constexpr double kArm_N_s_per_m = 20.0;          // keeps the finger from bouncing
constexpr double kArm_N_per_m = 300.0;           // along the slide; as the operators of the needle's study
constexpr double kFrom_m = -0.27, kTo_m = 0.13;  // the scene's ribs and a part of the flank on both sides
constexpr std::size_t kLeastRibs = 6;
// Under more than about 1 N the finger sinks between the scene's ribs to below their middle, and catches there: between
// them the scene has nothing but the skin's spring, where a chest has muscle.
constexpr std::array kPresses_N{0.5, 0.9};
constexpr double kFirm_N = 0.7;      // a press from here on is called firm
constexpr int kSlides = 4;           // with each press in each condition
constexpr double kOneRib_m = 0.012;  // touch and sight within this distance speak of one rib

constexpr Drawn<RibCounter> kRanges[] = {
    {"speed of the slide", "m/s", &RibCounter::speed_m_per_s, 0.03, 0.08, "assumed: no source was found"},
    {"tremor, RMS", "m", &RibCounter::tremor_m, 49e-6, 133e-6, "Riviere 1997"},
    {"noise of the felt force", "of the press", &RibCounter::force_jnd, 0.07, 0.2,
     "Pang 1991: 7 % at 2.5 to 10 N; 15 to 27 % below 1 N"},
    {"noise of the felt force, at least", "N", &RibCounter::force_floor_N, 0.03, 0.1, "assumed: no source was found"},
    {"noise of the felt height", "m", &RibCounter::height_m, 0.001, 0.003,
     "Hall and McCloskey 1983: movements of elbow and shoulder are noticed from 0.2 to 0.5 degrees on, 0.3 to 0.6 m "
     "from "
     "the joint"},
    {"noise of the seen height", "m", &RibCounter::sight_m, 0.0004, 0.0012,
     "one to two pixels of a headset of S2's kind (960 pixels over 100 degrees) at 0.3 to 0.4 m"},
    {"a change counts from", "SD", &RibCounter::caution, 3.5, 4.5, "assumed: below 3 SD, noise alone counts ribs"},
    {"ribs noticed and not counted", "of the ribs", &RibCounter::lapses, 0.0, 0.02, "assumed: no source was found"},
};

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

/// A slide between two gaps of the chest, so that the answer is not always the same number.
struct Stretch {
  double from_m, to_m;
  int ribs;
};
Stretch stretch_of(const Chest& chest, device::Random& random) {
  const auto count = chest.ribs_m.size();
  const auto gap = [&](std::size_t before) {
    if (before == 0) return chest.ribs_m.front() - 0.015;
    if (before == count) return chest.ribs_m.back() + 0.015;
    return 0.5 * (chest.ribs_m[before - 1] + chest.ribs_m[before]);
  };
  const auto first = static_cast<std::size_t>(random.uniform(0.0, 3.0));
  const auto last = count - static_cast<std::size_t>(random.uniform(0.0, 3.0));
  return {gap(first), gap(last), static_cast<int>(last - first)};
}

std::vector<Row> run_observer(const Chest& chest, std::uint64_t seed, std::size_t number) {
  device::Random self(seed_of(seed, kObserver, number));
  const RibCounter person = draw(rib_counter_ranges(), self);
  const std::vector<std::size_t> order = order_of(seed, number, 2);
  std::vector<Row> rows;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t condition = order[place];
    device::Random random(seed_of(seed, kTask * 1000 + condition, number));
    for (int trial = 0; trial < static_cast<int>(kPresses_N.size()) * kSlides; ++trial) {
      const double press_N = kPresses_N[static_cast<std::size_t>(trial) % kPresses_N.size()];
      const Stretch way = stretch_of(chest, random);
      const auto samples = slide(chest, press_N, person.speed_m_per_s, way.from_m, way.to_m, person.tremor_m, random);
      const int counted = counted_ribs(person, samples, press_N, condition == 1, random);
      rows.push_back({number,
                      condition,
                      trial,
                      {static_cast<double>(place), press_N, static_cast<double>(way.ribs), static_cast<double>(counted),
                       0.01 * static_cast<double>(samples.size())}});
    }
  }
  return rows;
}

/// The mean over the slides with one press of `figure`, for each observer and condition.
template <class Figure>
Measure measure_of(const std::vector<Row>& rows, const std::string& name, const std::string& unit, double press_N,
                   const Figure& figure) {
  Measure out{
      .name = name + (press_N < kFirm_N ? ", light press" : ", firm press"), .unit = unit, .first = {}, .second = {}};
  for (const Row& row : rows) {
    std::vector<double>& values = row.condition == 0 ? out.first : out.second;
    values.resize(std::max(values.size(), row.observer + 1), 0.0);
    if (row.values[1] == press_N) values[row.observer] += figure(row.values[2], row.values[3]) / kSlides;
  }
  return out;
}

std::vector<Measure> measures_of(const std::vector<Row>& rows) {
  std::vector<Measure> out;
  for (const double press_N : {kPresses_N[1], kPresses_N[0]}) {
    out.push_back(measure_of(rows, "ribs counted too much or too little", "ribs", press_N,
                             [](double true_ribs, double counted) { return std::abs(counted - true_ribs); }));
    out.push_back(measure_of(rows, "counts that are right", "%", press_N,
                             [](double true_ribs, double counted) { return true_ribs == counted ? 100.0 : 0.0; }));
  }
  return out;
}

std::vector<std::string> findings_of(const std::vector<Row>& rows) {
  double missed = 0.0, invented = 0.0, ribs = 0.0;
  for (const Row& row : rows) {
    missed += std::max(0.0, row.values[2] - row.values[3]);
    invented += std::max(0.0, row.values[3] - row.values[2]);
    ribs += row.values[2];
  }
  return {"Of all ribs, " + fixed_text(100.0 * missed / ribs) + " % were missed, and " +
          fixed_text(100.0 * invented / ribs) + " % were counted that are not there."};
}

std::vector<Curves> curves_of(const Chest& chest) {
  std::vector<Curves> out{{.title = "The finger's height under the skin",
                           .x_label = "along the chest [mm]",
                           .y_label = "height [mm]",
                           .curves = {}},
                          {.title = "The force along the slide",
                           .x_label = "along the chest [mm]",
                           .y_label = "force on the finger [N]",
                           .curves = {}}};
  for (const double press_N : kPresses_N) {
    device::Random random(1);
    const std::string name = fixed_text(press_N) + " N";
    for (Curves& curves : out) curves.curves.push_back({name, {}, {}});
    for (const SlideSample& sample : slide(chest, press_N, 0.05, kFrom_m, kTo_m, 0.0, random)) {
      for (Curves& curves : out) curves.curves.back().x.push_back(1e3 * sample.z_m);
      out[0].curves.back().y.push_back(1e3 * sample.height_m);
      out[1].curves.back().y.push_back(sample.along_N);
    }
  }
  return out;
}

}  // namespace

std::span<const Drawn<RibCounter>> rib_counter_ranges() noexcept { return kRanges; }

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
  for (const SlideSample& sample : slide(chest, kPresses_N.back(), 0.02, kFrom_m, kTo_m, 0.0, still))
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

Experiment rib_experiment(Chest chest) {
  const auto shared = std::make_shared<const Chest>(std::move(chest));  // shared: the experiment's functions read it
  Experiment out;
  out.name = "rib-count";
  out.title = "Ribs counted by touch, and with the finger drawn under the skin";
  out.task =
      "An observer presses a finger on a chest with 0.5 N or 0.9 N, slides along it, and counts the ribs passed. The "
      "chest is the scene ribs-ultrasound, felt at 2 kHz as at the device. By touch, a rib counts when the force along "
      "the slide holds the finger back and lets it go, or when the hand rises and falls. Drawn, the "
      "rise "
      "and fall are seen, too. All within 12 mm are one rib. Each slide passes 7 to 12 ribs.";
  out.conditions = {"touch", "drawn"};
  out.subjects = Subjects::Within;
  out.columns = "observer,condition,trial,place,press_N,ribs,counted,seconds";
  out.values = 5;
  out.ranges = in_words(rib_counter_ranges());
  out.limits = {
      "S2 counted no ribs: two doctors and two others tried its scene, without numbers. There is nothing to compare "
      "with.",
      "Not shown: whether a doctor knows which rib a finger is on. Doctors count from a landmark, and go back when "
      "unsure. These observers slide once.",
      "The skin is flat and at rest. A patient breathes."};
  out.run = [shared](std::uint64_t seed, std::size_t observer) { return run_observer(*shared, seed, observer); };
  out.measures = measures_of;
  out.findings = findings_of;
  out.curves = [shared](const std::vector<Row>&) { return curves_of(*shared); };
  return out;
}

}  // namespace telepalp::study
