#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/effects/bank/bank_steps.h"
#include "haptic_station/station/bill/thread_time.h"
#include "tests/bench/distribution.h"
#include "tests/bench/needle/section.h"
#include "tests/bench/tick_times.h"

namespace telepalp::bench {
namespace {

/// A bank as it would be without tissue: all kinds of effects but LayeredTissue and FemPrism.
using OtherKinds = std::variant<effects::Skin, effects::InnerCylinder, effects::InnerSphere, effects::Friction,
                                effects::StiffRegions, effects::Organ, effects::Solid, effects::Membrane>;
using BankOfOthers = effects::BasicEffectBank<OtherKinds>;
static_assert(std::variant_size_v<effects::Effect> == std::variant_size_v<OtherKinds> + 2);

/// A hand that presses up to 10 mm deep, and rubs.
effects::EffectInput input_at(double time_s) {
  effects::EffectInput in;
  in.contact.normal.v = Eigen::Vector3d::UnitY();
  in.contact.valid = in.contact.in_body = true;
  in.device.m = {0.01 * std::sin(7.0 * time_s), -0.005 * (1.0 - std::cos(3.0 * time_s)), 0.0};
  in.contact.distance_m = -in.device.m.y();
  in.moved.v = kTick_s * Eigen::Vector3d(0.07 * std::cos(7.0 * time_s), -0.015 * std::sin(3.0 * time_s), 0.0);
  in.device_velocity.v = in.moved.v / kTick_s;
  return in;
}

/// A bank that feels a skin, and what its ticks cost.
template <class Bank>
struct Feeling {
  explicit Feeling(const effects::SkinSettings& skin) {
    (void)bank.add(typename Bank::Effect(effects::Skin(skin)));
    bank.begin(input_at(0.0));
  }
  /// Processor time of the ticks of one second [ns].
  double second_ns() {
    const std::int64_t before_ns = station::thread_ns();
    for (int i = 0; i < 2000; ++i) force_N += bank.step(input_at(kTick_s * ++ticks), kTick_s).force.N;
    return static_cast<double>(station::thread_ns() - before_ns);
  }
  Bank bank;
  int ticks = 0;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();  ///< sum over all ticks
};

/// A station's processor time differs by some 0.5 % of a core from run to run (`telepalp-bench users`, bill).
constexpr double kTenthOfNoise_percent = 0.05;

/// A skin alone, felt by the product's bank and by one without the kinds of tissue, in turn. Two banks of the same kind
/// show the noise.
void add_cost_of_unused_kinds(std::vector<Row>& rows) {
  const effects::SkinSettings skin = *library_scene("skin").skin();
  Feeling<effects::EffectBank> shipped(skin);
  Feeling<BankOfOthers> without(skin);
  Feeling<BankOfOthers> again(skin);
  Distribution shipped_ratio;
  Distribution again_ratio;
  Distribution more_ns;
  for (int turn = 0; turn < 301; ++turn) {
    const double without_ns = without.second_ns();
    const double shipped_ns = shipped.second_ns();
    shipped_ratio.add(shipped_ns / without_ns);
    again_ratio.add(again.second_ns() / without_ns);
    more_ns.add(shipped_ns - without_ns);
  }
  rows.push_back(at_most("skin alone: change of the force by the kinds of tissue, of 602 000 ticks",
                         (shipped.force_N - without.force_N).norm(), "N", 0.0));
  rows.push_back(at_most("skin alone: processor time that the kinds of tissue add to a station, share of a core",
                         100.0 * more_ns.p50() / 1e9, "%", kTenthOfNoise_percent));
  rows.push_back(measured("skin alone: processor time of the bank's ticks, over that of a bank without tissue",
                          shipped_ratio.p50(), "s/s"));
  rows.push_back(measured("skin alone: the same of two banks without tissue", again_ratio.p50(), "s/s"));
}

/// The steps of tissue in the bills of the library's other scenes, after 1000 ticks in contact. More than 0 would mean
/// that scenes without a needle pay for it.
Row paid_without_tissue() {
  const auto folder = scenes::find_scene("palpation")->parent_path();
  std::uint64_t steps = 0;
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".scene.textproto")) continue;
    const Result<scenes::Scene> scene = scenes::read_scene(entry.path());
    if (!scene || std::ranges::any_of(scene->effects, [](const effects::Recipe& recipe) {
          return std::holds_alternative<effects::LayeredTissueSettings>(recipe) ||
                 std::holds_alternative<effects::FemPrismSettings>(recipe);
        }))
      continue;
    ++scenes;
    effects::EffectBank bank = core::bank_of(scene->effects);
    bank.begin(input_at(0.0));
    for (int i = 0; i < 1000; ++i) (void)bank.step(input_at(kTick_s * i), kTick_s);
    for (const effects::EffectBill& bill : bank.bill())
      if (bill.name == std::string_view(effects::LayeredTissue::kName) ||
          bill.name == std::string_view(effects::FemPrism::kName))
        steps += bill.steps;
  }
  return at_most("steps of a tissue in the bills of the library's other scenes, " + std::to_string(scenes) + " of them",
                 static_cast<double>(steps), "", 0.0);
}

}  // namespace

std::vector<Row> run_needle_others_section() {
  std::vector<Row> rows;
  add_cost_of_unused_kinds(rows);
  rows.push_back(paid_without_tissue());
  return rows;
}

}  // namespace telepalp::bench
