#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/needle_paths.h"
#include "tests/hard_cases/control/forced_path.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;

/// Part of the net's energy before the puncture that is neither given back to the hand, nor dissipated, nor still
/// stored; the greatest over three motions of the tip after the puncture. The surface alone, without friction and
/// relaxation.
double missing_share(const tissue::SurfaceSettings& given) {
  double worst = 0.0;
  for (const double speed_m_per_s : {0.002, 0.05, -0.05}) {
    tissue::Insertion run = tissue::just_punctured(given, {0.002, 0.005, 0.0});
    const double before_J = run.tissue.stored_J();
    const double taken_J = run.taken_J;
    for (int i = 0; i < 200; ++i) run.tick(run.needle.tip_m - Vector3d(0.0, speed_m_per_s * kTick_s, 0.0));
    const double found_J = taken_J - run.taken_J + run.tissue.punctures_dissipated_J() + run.tissue.stored_J();
    worst = std::max(worst, std::abs(before_J - found_J) / before_J);
  }
  return worst;
}

/// `tissue` with all its stiffnesses times 10, and with one law of stick and slip.
tissue::TissueSettings ten_times(tissue::TissueSettings tissue, tissue::BulkLaw law) {
  for (tissue::LayerSettings& layer : tissue.layers) {
    if (layer.surface) {
      layer.surface->stiffness_N_per_m *= 10.0;
      layer.surface->stiffening_N_per_m2 *= 10.0;
      layer.surface->bristle_N_per_m *= 10.0;
    }
    if (layer.bulk) {
      layer.bulk->stick_N_per_m *= 10.0;
      layer.bulk->law = law;
    }
  }
  tissue.shaft.side_N_per_m *= 10.0;
  return tissue;
}

struct Gain {
  double display_J = 0.0;  ///< the most by which stored energy exceeded what the display's ledger had taken
  double hand_J = 0.0;     ///< the most energy that the hand got in excess, by the hand's ledger
};

effects::Effect stiff_tissue(const scenes::Scene& scene, tissue::BulkLaw law) {
  return effects::LayeredTissue({.model = *tissue::make_tissue(ten_times(tissue_of(scene), law))});
}

/// A needle on a prescribed path wanders for 1e5 ticks, 50 s, through `felt`.
Gain gained(std::initializer_list<effects::Effect> felt) {
  constexpr int kWanders_ticks = 100'000;
  effects::EffectBank bank;
  for (const effects::Effect& effect : felt) (void)bank.add(effect);
  std::vector<Vector3d> places;
  tissue::Wanderer tip({0.0, 0.005, 0.0}, 3);
  for (int i = 0; i < kWanders_ticks; ++i) places.push_back(tip.next());
  const auto place = [&](double s) {
    const auto i = static_cast<std::size_t>(std::lround(s / kTick_s));
    return places[std::min(i, places.size() - 1)];
  };
  hard_cases::ForcedPath run{
      .seconds = hard_cases::ForcedPath::kDown_s + kWanders_ticks * kTick_s, .effects = bank, .path = place};
  Gain gain;
  run.watch = [&](const control::ControlOutput& out, double) {
    gain.display_J = std::max(gain.display_J, -out.passivity_J);
    gain.hand_J = std::max(gain.hand_J, out.hand_excess_J);
  };
  (void)hard_cases::feel(run);
  return gain;
}

}  // namespace

std::vector<Row> run_needle_energy_section() {
  std::vector<Row> rows;
  for (const std::string_view name : kNeedleScenes) {
    const scenes::Scene scene = library_scene(name);
    for (const tissue::LayerSettings& layer : tissue_of(scene).layers)
      if (layer.surface)
        rows.push_back(at_most(std::string(name) + ": " + layer.name + " ruptures: energy unaccounted for",
                               100.0 * missing_share(*layer.surface), "%", 1.0));
  }
  constexpr std::pair<const char*, tissue::BulkLaw> kLaws[]{
      {"bristle", tissue::BulkLaw::Bristle}, {"window", tissue::BulkLaw::Window}, {"paper", tissue::BulkLaw::Paper}};
  for (const std::string_view name : kNeedleScenes)
    for (const auto& [setting, law] : kLaws) {
      const scenes::Scene scene = library_scene(name);
      const Gain gain = gained({effects::Skin(*scene.skin()), stiff_tissue(scene, law)});
      const std::string row = std::string(name) + ", 10 times as stiff, " + setting + ": energy gained in 1e5 steps, ";
      rows.push_back(at_most(row + "the display's ledger", 1e3 * gain.display_J, "mJ", 0.0));
      rows.push_back(at_most(row + "the hand's ledger", 1e3 * gain.hand_J, "mJ", 0.0));
    }
  // The parts of this gain: the skin on the same path without a needle, and the tissue without the skin.
  const scenes::Scene scene = library_scene(kNeedleScenes[0]);
  const Gain skin = gained({effects::Skin(*scene.skin())});
  const Gain layers = gained({stiff_tissue(scene, tissue::BulkLaw::Bristle)});
  rows.push_back(
      measured("the skin alone: energy gained in 1e5 steps, the display's ledger", 1e3 * skin.display_J, "mJ"));
  rows.push_back(measured("the skin alone: energy gained in 1e5 steps, the hand's ledger", 1e3 * skin.hand_J, "mJ"));
  rows.push_back(measured("the tissue alone, 10 times as stiff: energy gained in 1e5 steps, the display's ledger",
                          1e3 * layers.display_J, "mJ"));
  rows.push_back(measured("the tissue alone, 10 times as stiff: energy gained in 1e5 steps, the hand's ledger",
                          1e3 * layers.hand_J, "mJ"));
  return rows;
}

}  // namespace telepalp::bench
