#include <algorithm>
#include <filesystem>
#include <string>

#include "haptic_station/core/built_effects.h"
#include "tests/bench/needle/section.h"
#include "tests/bench/tick_times.h"

namespace telepalp::bench {
namespace {

/// The steps of the effect `layered_tissue` in the bills of the library's other scenes, after 1000 ticks in contact.
/// More than 0 would mean that scenes without a needle pay for it.
Row paid_without_tissue() {
  const auto folder = scenes::find_scene("palpation")->parent_path();
  std::uint64_t steps = 0;
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".scene.textproto")) continue;
    const Result<scenes::Scene> scene = scenes::read_scene(entry.path());
    if (!scene || std::ranges::any_of(scene->effects, [](const effects::Recipe& recipe) {
          return std::holds_alternative<effects::LayeredTissueSettings>(recipe);
        }))
      continue;
    ++scenes;
    effects::EffectBank bank = core::bank_of(scene->effects);
    effects::EffectInput in;
    in.contact.normal.v = Eigen::Vector3d::UnitY();
    in.contact.valid = in.contact.in_body = true;
    bank.begin(in);
    for (int i = 0; i < 1000; ++i) (void)bank.step(in, kTick_s);
    for (const effects::EffectBill& bill : bank.bill())
      if (bill.name == effects::LayeredTissue::kName) steps += bill.steps;
  }
  return at_most("steps of a tissue in the bills of the library's other scenes, " + std::to_string(scenes) + " of them",
                 static_cast<double>(steps), "", 0.0);
}

}  // namespace

std::vector<Row> run_needle_tick_section() {
  std::vector<Row> rows;
  for (const std::string_view name : kNeedleScenes) {
    const scenes::Scene scene = library_scene(name);
    const TickTimes took = measure_ticks(core::bank_of(scene.effects), scene.trial, device::duration_s(scene.trial));
    const std::string tick = std::string(name) + ": tick: time, ";
    rows.push_back(at_most(tick + "p50", took.all.p50(), "us", 20.0));
    rows.push_back(at_most(tick + "p99.9", took.all.p999(), "us", 100.0));
    rows.push_back(measured(tick + "p50 in contact", took.contact.p50(), "us"));
    rows.push_back(measured(std::string(name) + ": tick: processor time, p99.9", took.processor.p999(), "us"));
    rows.push_back(measured(std::string(name) + ": ticks in contact", static_cast<double>(took.contact.count()), ""));
  }
  rows.push_back(paid_without_tissue());
  return rows;
}

}  // namespace telepalp::bench
