#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/tissue/tissue_settings.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// One group of rows of `telepalp-bench needle`; `--part NAME` runs it alone.
struct NeedleSection {
  std::string_view name;
  std::string_view purpose;
  std::vector<Row> (*run)();
};

/// Time of a tick of each needle scene, and the cost of needles for the other scenes.
[[nodiscard]] std::vector<Row> run_needle_tick_section();
/// Energy of ruptures, and energy gained on long paths through stiff tissue.
[[nodiscard]] std::vector<Row> run_needle_energy_section();
/// How steadily the force changes: at ruptures, where nothing ruptures or slips, and where the net is subdivided.
[[nodiscard]] std::vector<Row> run_needle_force_section();
/// The falling force of a needle that rests, compared with needles in human livers.
[[nodiscard]] std::vector<Row> run_needle_relaxation_section();
/// A prism of finite elements: its return to rest, its stiffness, the price of its meshes.
[[nodiscard]] std::vector<Row> run_needle_fem_section();
/// Local models of the prism at 62 Hz in the place of the prism itself: force, energy, steps.
[[nodiscard]] std::vector<Row> run_needle_hand_over_section();
/// Error of tissues that are fitted to measured insertions. `folder` has files liver_NN.csv or liver_NN.csv.gz with the
/// columns displacement_mm and force_N.
[[nodiscard]] std::vector<Row> run_needle_insertion_section(const std::string& folder);

/// The scenes with layers of tissue.
inline constexpr std::string_view kNeedleScenes[]{"amniocentesis", "biopsy-two-layers", "lumbar-puncture"};

/// A scene of the library.
[[nodiscard]] scenes::Scene library_scene(std::string_view name);
/// The tissue of a scene of kNeedleScenes.
[[nodiscard]] const tissue::TissueSettings& tissue_of(const scenes::Scene& scene);

}  // namespace telepalp::bench
