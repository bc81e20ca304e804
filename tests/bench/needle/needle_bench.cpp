#include "tests/bench/needle/needle_bench.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "haptic_station/tissue/tissue_settings.h"
#include "proto/words/demand.h"
#include "tests/bench/choice.h"
#include "tests/bench/needle/section.h"

namespace telepalp::bench {
namespace {

const std::vector<NeedleSection> kSections{
    {"tick", "time of a tick with a needle", run_needle_tick_section},
    {"others", "what scenes without a needle pay for it", run_needle_others_section},
    {"energy", "energy of ruptures and of long paths", run_needle_energy_section},
    {"force", "steps of the force", run_needle_force_section},
    {"relaxation", "the force of a stopped needle", run_needle_relaxation_section},
    {"contact", "the vertex nearest to a tip and its way through a mesh: wrong answers and cost",
     run_needle_contact_section},
    {"fem", "a prism of finite elements: return to rest, stiffness, price", run_needle_fem_section},
    {"mechanism", "a needle on a linkage: virtual work and dead points", run_needle_mechanism_section},
    {"felt", "a linkage whose parts are felt and grasped", run_needle_felt_section},
    {"hand-over", "the prism's local models at 62 Hz: force and energy", run_needle_hand_over_section},
};

}  // namespace

scenes::Scene library_scene(std::string_view name) {
  const auto file = scenes::find_scene(std::string(name));
  demand(file.ok(), "the library has the scene");
  Result<scenes::Scene> scene = scenes::read_scene(*file);
  demand(scene.ok(), "the library's scenes are right");
  return std::move(*scene);
}

const tissue::TissueSettings& tissue_of(const scenes::Scene& scene) {
  for (const effects::Recipe& recipe : scene.effects)
    if (const auto* needle = std::get_if<effects::LayeredTissueSettings>(&recipe))
      return tissue::settings_of(*needle->model);
  demand(false, "a needle scene has a tissue");
  std::abort();
}

Result<Report> run_needle(const program::Arguments& arguments) {
  const Result<std::vector<NeedleSection>> sections = chosen_sections(kSections, arguments, "needle");
  if (!sections) return sections.error();
  const bool insertions = arguments.has("input") && !arguments.has("part");
  if (insertions && !std::filesystem::is_directory(arguments.text("input")))
    return Error{.what = "'" + arguments.text("input") + "' is not a folder",
                 .where = "--input",
                 .fix = "give a folder with files liver_NN.csv or liver_NN.csv.gz"};
  Report report{.bench = "needle", .rows = {}, .notes = {}};
  for (const NeedleSection& section : *sections) {
    std::fprintf(stderr, "telepalp-bench needle: %.*s: %.*s\n", static_cast<int>(section.name.size()),
                 section.name.data(), static_cast<int>(section.purpose.size()), section.purpose.data());
    for (Row& row : section.run()) report.rows.push_back(std::move(row));
  }
  if (insertions)
    for (Row& row : run_needle_insertion_section(arguments.text("input"))) report.rows.push_back(std::move(row));
  report.notes.push_back(
      "the tissue of the scenes as shipped; in rows with \"10 times as stiff\", all its stiffnesses are multiplied by "
      "10");
  return report;
}

}  // namespace telepalp::bench
