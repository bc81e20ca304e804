#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/tissue/tissue_settings.h"
#include "proto/words/time.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// One group of rows of `telepalp-bench needle`; `--part NAME` runs it alone.
struct NeedleSection {
  std::string_view name;
  std::string_view purpose;
  std::vector<Row> (*run)();
};

/// Time of a tick of each needle scene.
[[nodiscard]] std::vector<Row> run_needle_tick_section();
/// What scenes without tissue pay for it.
[[nodiscard]] std::vector<Row> run_needle_others_section();
/// Energy of ruptures, and energy gained on long paths through stiff tissue.
[[nodiscard]] std::vector<Row> run_needle_energy_section();
/// How steadily the force changes: at ruptures, where nothing ruptures or slips, and where the net is subdivided.
[[nodiscard]] std::vector<Row> run_needle_force_section();
/// The falling force of a needle that rests, compared with needles in human livers.
[[nodiscard]] std::vector<Row> run_needle_relaxation_section();
/// The methods that find contacts, against all vertices and all triangles: wrong answers and cost.
[[nodiscard]] std::vector<Row> run_needle_contact_section();
/// A prism of finite elements: its return to rest, its stiffness, the price of its meshes.
[[nodiscard]] std::vector<Row> run_needle_fem_section();
/// Local models of the prism at 62 Hz in the place of the prism itself: force, energy, steps.
[[nodiscard]] std::vector<Row> run_needle_hand_over_section();
/// Force on the hand that holds a needle by a four-bar linkage: virtual work, and dead points.
[[nodiscard]] std::vector<Row> run_needle_mechanism_section();
/// A linkage whose parts a hand feels and grasps: virtual work at any part, steps of the force, time of a tick.
[[nodiscard]] std::vector<Row> run_needle_felt_section();
/// Error of tissues that are fitted to measured insertions. `folder` has files liver_NN.csv or liver_NN.csv.gz with the
/// columns displacement_mm and force_N.
[[nodiscard]] std::vector<Row> run_needle_insertion_section(const std::string& folder);

/// The force of the effect `fem_prism` under a hand at up to 0.1 m/s, compared with that of the same prism computed in
/// each tick of 2 kHz.
struct HandOverError {
  double percent = 0.0;       ///< RMS error over the RMS force
  double most_N = 0.0;        ///< greatest force of the prism computed at 2 kHz
  double models_per_s = 0.0;  ///< handed over
};
/// For each cost of a run of the slow stage. Beyond the stage's period, the cost lowers the rate. Takes some seconds.
[[nodiscard]] std::vector<HandOverError> hand_over_errors(const std::vector<Nanoseconds>& costs);

/// Lateral stiffness of the top of a prism of 20 x 20 x 100 mm with an infinitely fine mesh, per pascal of Young's
/// modulus [m]: the limit of quadratic tetrahedra in 1, 2 and 4 cubes across, whose errors fall by the same factor
/// (Aitken).
[[nodiscard]] double converged_prism_per_Pa(double poisson);

/// A method that finds a contact.
struct ContactCost {
  const char* method = "";
  std::uint64_t wrong = 0;  ///< answers that differ from those of all vertices, or of all triangles
  double ns = 0.0;          ///< processor time of an answer, p50 over blocks of answers
};
/// A tip that moves through a mesh at one speed.
struct ContactCase {
  const char* mesh = "";
  double speed_m_per_s = 0.0;
  std::uint64_t ticks = 0;      ///< of each method
  std::uint64_t crossings = 0;  ///< ticks in which the tip passes through the mesh
  std::uint64_t searches = 0;   ///< of the proven walk
  std::vector<ContactCost> vertex;
  std::vector<ContactCost> crossing;
};
/// Each mesh at each speed. Takes some seconds.
[[nodiscard]] std::vector<ContactCase> contact_cases();

/// The scenes with layers of tissue.
inline constexpr std::string_view kNeedleScenes[]{"amniocentesis", "biopsy-two-layers", "lumbar-puncture"};

/// A scene of the library.
[[nodiscard]] scenes::Scene library_scene(std::string_view name);
/// The tissue of a scene of kNeedleScenes.
[[nodiscard]] const tissue::TissueSettings& tissue_of(const scenes::Scene& scene);

}  // namespace telepalp::bench
