#include "tools/study/run/study.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <optional>

#include "support/program/parallel.h"
#include "tools/study/run/block_order.h"
#include "tools/study/run/parts.h"
#include "tools/study/run/seeds.h"
#include "tools/study/run/trial_row.h"

namespace telepalp::study {
namespace {

using Model = std::shared_ptr<const tissue::TissueModel>;

/// The seed of a penetration is the same for all mechanisms of a design and for all conditions, so only mechanism and
/// condition make a difference.
Outcome one_penetration(const StudySettings& settings, const Person& person, const Model& model, std::size_t number,
                        Condition condition, const Configuration& mechanism, std::uint64_t penetration,
                        Learned& learned) {
  const Result<std::unique_ptr<HeldTool>> tool = linkage_tool(mechanism, person.plant);
  device::Random random(seed_of(settings.seed, kPenetration * 1000 + number, penetration));
  return penetrate({**tool, model, person.self, condition}, learned, random);
}

/// One operator in one condition: training with a few mechanisms, then all of them in random order.
std::vector<Trial> run_block(const StudySettings& settings, const Model& model, std::size_t number,
                             Condition condition) {
  const Person person = person_of(settings, number);
  const auto& mechanisms = settings.design.configurations;
  const BlockOrder block = block_order(settings.seed, number, condition, mechanisms.size());
  Learned learned{.depth_m = person.plant.sac_depth_m * std::clamp(1.0 + 0.2 * block.first_guess, 0.5, 1.5), .from = 1};
  for (std::size_t i = 0; i < std::min<std::size_t>(kTrainingMechanisms, block.training.size()); ++i)
    for (std::uint64_t k = 0; k < kTrainingPenetrations; ++k)
      (void)one_penetration(settings, person, model, number, condition, mechanisms[block.training[i]], 100 + 10 * i + k,
                            learned);
  std::vector<Trial> trials;
  const std::vector<std::size_t>& order = block.formal;
  for (std::size_t place = 0; place < order.size(); ++place)
    for (int k = 0; k < settings.penetrations; ++k)
      trials.push_back({.person = number,
                        .condition = condition,
                        .place = place,
                        .configuration = order[place],
                        .penetration = k,
                        .outcome = one_penetration(settings, person, model, number, condition, mechanisms[order[place]],
                                                   static_cast<std::uint64_t>(k), learned)});
  return trials;
}

Result<std::vector<Model>> models_of(const StudySettings& settings) {
  std::vector<Model> models;
  for (std::size_t i = 0; i < static_cast<std::size_t>(settings.operators); ++i) {
    const Plant plant = person_of(settings, i).plant;
    Result<Model> model = tissue::make_tissue(tissue_of(plant));
    if (!model) return model.error();
    models.push_back(std::move(*model));
    for (const Configuration& mechanism : settings.design.configurations)
      if (const Result<std::unique_ptr<HeldTool>> tool = linkage_tool(mechanism, plant); !tool)
        return Error{.what = tool.error().what + ", for operator " + std::to_string(i + 1),
                     .where = settings.design.name,
                     .fix = tool.error().fix};
  }
  return models;
}

/// `models`: the tissue of each operator, for Parts::make alone. The parts refer to `settings`, which must outlive
/// them.
Parts parts_with(const StudySettings& settings, std::vector<Model> models) {
  const auto number = [](int part) { return static_cast<std::size_t>(part) / kStudied.size(); };
  const auto condition = [](int part) { return kStudied[static_cast<std::size_t>(part) % kStudied.size()]; };
  const std::size_t rows = settings.design.configurations.size() * static_cast<std::size_t>(settings.penetrations);
  Parts parts{.folder = settings.out / "runs",
              .identity = identity_of(settings),
              .columns = kTrialColumns,
              .count = settings.operators * static_cast<int>(kStudied.size()),
              .file = {},
              .is_whole = {},
              .make = {}};
  parts.file = [=](int part) {
    char text[64];
    std::snprintf(text, sizeof text, "operator-%03zu-%s.csv", number(part) + 1,
                  std::string(name(condition(part))).c_str());
    return std::string(text);
  };
  parts.is_whole = [=](const std::vector<std::string>& found) {
    return found.size() == rows &&
           std::all_of(found.begin(), found.end(), [](const auto& row) { return read_trial(row).has_value(); });
  };
  parts.make = [=, models = std::move(models), &settings](int part) {
    std::vector<std::string> made;
    for (const Trial& trial : run_block(settings, models[number(part)], number(part), condition(part)))
      made.push_back(trial_row(trial));
    return made;
  };
  return parts;
}

}  // namespace

Person person_of(const StudySettings& settings, std::size_t number) noexcept {
  device::Random self(seed_of(settings.seed, kPerson, number));
  device::Random plant(seed_of(settings.seed, kPlant, number));
  return {draw(operator_ranges(), self), draw(plant_ranges(), plant)};
}

Parts parts_of(const StudySettings& settings) { return parts_with(settings, {}); }

Result<std::vector<Trial>> run_study(const StudySettings& settings, const std::function<void(int)>& finished) {
  const Result<std::vector<Model>> models = models_of(settings);
  if (!models) return models.error();
  const auto blocks = run_parts(parts_with(settings, *models), settings.threads, finished);
  if (!blocks) return blocks.error();
  std::vector<Trial> all;
  for (const std::vector<std::string>& block : *blocks)
    for (const std::string& row : block) all.push_back(*read_trial(row));
  return all;
}

Result<Check> check_operators(const StudySettings& settings) {
  constexpr Condition kConditions[] = {Condition::Neither, Condition::Force, Condition::SeesLayers, Condition::Both};
  constexpr std::uint64_t kEach = 10;
  std::vector<std::array<double, 4>> means(static_cast<std::size_t>(settings.operators));
  std::mutex one_at_a_time;
  std::optional<Error> failed;
  program::for_each_parallel(settings.operators, settings.threads, [&](int i) {
    const auto number = static_cast<std::size_t>(i);
    const Person person = person_of(settings, number);
    const Result<Model> model = tissue::make_tissue(tissue_of(person.plant));
    if (!model) {
      const std::lock_guard lock(one_at_a_time);
      failed = model.error();
      return;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      Learned learned{.depth_m = person.plant.sac_depth_m + person.plant.sac_punctures_at_N / person.plant.sac_N_per_m,
                      .from = 5};
      for (std::uint64_t k = 0; k < kEach; ++k) {
        device::Random random(seed_of(settings.seed, kCheck * 1000 + number, k));
        const std::unique_ptr<HeldTool> tool = straight_tool();
        const Outcome out = penetrate({*tool, *model, person.self, kConditions[c]}, learned, random);
        means[number][c] += (-tool->tip_m().y() - out.depth_at_puncture_m) / kEach;
      }
    }
  });
  if (failed) return *failed;
  Check check;
  for (const std::array<double, 4>& one : means) {
    check.neither_m += one[0] / settings.operators;
    check.force_m += one[1] / settings.operators;
    check.sees_layers_m += one[2] / settings.operators;
    check.both_m += one[3] / settings.operators;
  }
  return check;
}

}  // namespace telepalp::study
