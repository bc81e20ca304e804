#include "tools/study/experiments/ribs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "proto/words/numbers/fixed_text.h"

namespace telepalp::study {
namespace {

constexpr std::array kPresses_N{kLightPress_N, kFirmPress_N};
constexpr int kSlides = 4;  // with each press in each condition

enum SlideValue : std::size_t {
  kSlidePlace,
  kPress_N,
  kRibs,
  kCounted,
  kSlideSeconds
};  // of a row, in the order of its columns

constexpr Drawn<RibCounter> kRibCounterRanges[] = {
    {"speed of the slide", "m/s", &RibCounter::speed_m_per_s, 0.03, 0.08, "assumed: no source was found"},
    {"tremor, RMS", "m", &RibCounter::tremor_m, 49e-6, 133e-6, "Riviere 1997"},
    {"noise of the felt force", "of the press", &RibCounter::force_jnd, 0.07, 0.2,
     "Pang 1991: 7 % at 2.5 to 10 N; 15 to 27 % below 1 N"},
    {"noise of the felt force, at least", "N", &RibCounter::force_floor_N, 0.03, 0.1, "assumed: no source was found"},
    {"noise of the felt height", "m", &RibCounter::height_m, 0.001, 0.003,
     "Hall and McCloskey 1983: movements of elbow and shoulder are noticed from 0.2 to 0.5 degrees on, 0.3 to 0.6 m "
     "from the joint"},
    {"noise of the seen height", "m", &RibCounter::sight_m, 0.0004, 0.0012,
     "one to two pixels of a headset of S2's kind (960 pixels over 100 degrees) at 0.3 to 0.4 m"},
    {"a change counts from", "SD", &RibCounter::caution, 3.5, 4.5, "assumed: below 3 SD, noise alone counts ribs"},
    {"ribs noticed and not counted", "of the ribs", &RibCounter::lapses, 0.0, 0.02, "assumed: no source was found"},
};

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
  Measure out{.name = name + (press_N < kFirmPress_N ? ", light press" : ", firm press"),
              .unit = unit,
              .first = {},
              .second = {}};
  for (const Row& row : rows) {
    std::vector<double>& values = row.condition == 0 ? out.first : out.second;
    values.resize(std::max(values.size(), row.observer + 1), 0.0);
    if (row.values[kPress_N] == press_N)
      values[row.observer] += figure(row.values[kRibs], row.values[kCounted]) / kSlides;
  }
  return out;
}

std::vector<Measure> slide_measures(const std::vector<Row>& rows) {
  std::vector<Measure> out;
  for (const double press_N : {kFirmPress_N, kLightPress_N}) {
    out.push_back(measure_of(rows, "ribs counted too many or too few", "ribs", press_N,
                             [](double true_ribs, double counted) { return std::abs(counted - true_ribs); }));
    out.push_back(measure_of(rows, "counts that are right", "%", press_N,
                             [](double true_ribs, double counted) { return true_ribs == counted ? 100.0 : 0.0; }));
  }
  return out;
}

std::vector<std::string> slide_findings(const std::vector<Row>& rows) {
  double missed = 0.0, invented = 0.0, ribs = 0.0;
  for (const Row& row : rows) {
    missed += std::max(0.0, row.values[kRibs] - row.values[kCounted]);
    invented += std::max(0.0, row.values[kCounted] - row.values[kRibs]);
    ribs += row.values[kRibs];
  }
  return {"Of all ribs, " + fixed_text(100.0 * missed / ribs) + " % were missed, and " +
          fixed_text(100.0 * invented / ribs) + " % were counted that are not there."};
}

std::vector<Curves> slide_curves(const Chest& chest) {
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
    for (const SlideSample& sample : slide(chest, press_N, 0.05, kChestFrom_m, kChestTo_m, 0.0, random)) {
      for (Curves& curves : out) curves.curves.back().x.push_back(1e3 * sample.z_m);
      out[0].curves.back().y.push_back(1e3 * sample.height_m);
      out[1].curves.back().y.push_back(sample.along_N);
    }
  }
  return out;
}

}  // namespace

std::span<const Drawn<RibCounter>> rib_counter_ranges() noexcept { return kRibCounterRanges; }

Experiment rib_experiment(Chest chest) {
  const auto shared = std::make_shared<const Chest>(std::move(chest));  // shared: the experiment's functions read it
  Experiment out;
  out.name = "rib-count";
  out.title = "Ribs counted by touch, and with the finger drawn under the skin";
  out.task =
      "An observer presses a finger on a chest with 0.5 N or 0.9 N, slides along it, and counts the ribs passed. The "
      "chest is the scene ribs-ultrasound, felt at 2 kHz as at the device. By touch, a rib counts when the force along "
      "the slide holds the finger back and lets it go, or when the hand rises and falls. Drawn, the rise "
      "and fall are seen, too. Signs within 12 mm of each other are one rib. Each slide passes 7 to 12 ribs.";
  out.conditions = {"touch", "drawn"};
  out.subjects = Subjects::Within;
  out.columns = "observer,condition,trial,place,press_N,ribs,counted,seconds";
  out.ranges = in_words(rib_counter_ranges());
  out.limits = {
      "S2 counted no ribs: two doctors and two others tried its scene, without numbers. There is nothing to compare "
      "with.",
      "Not shown: whether a doctor knows which rib a finger is on. Doctors count from a landmark, and go back when "
      "unsure. These observers slide once.",
      "The skin is flat and at rest. A patient breathes."};
  out.run = [shared](std::uint64_t seed, std::size_t observer) { return run_observer(*shared, seed, observer); };
  out.measures = slide_measures;
  out.findings = slide_findings;
  out.curves = [shared](const std::vector<Row>&) { return slide_curves(*shared); };
  return out;
}

}  // namespace telepalp::study
