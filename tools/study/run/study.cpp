#include "tools/study/run/study.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <mutex>
#include <numeric>
#include <optional>

#include "support/program/files/whole_file.h"
#include "support/program/parallel.h"
#include "tools/study/run/block_file.h"

namespace telepalp::study {
namespace {

constexpr int kTrainingMechanisms = 3;
constexpr int kTrainingPenetrations = 5;

// Parts of the study that draw independent numbers.
enum Part : std::uint64_t { kPerson = 1, kPlant, kOrder, kFirstGuess, kPenetration, kCheck };

std::filesystem::path file_of(const StudySettings& settings, std::size_t block) {
  char text[64];
  std::snprintf(text, sizeof text, "operator-%03zu-%s.csv", block / kStudied.size() + 1,
                std::string(name(kStudied[block % kStudied.size()])).c_str());
  return settings.out / "runs" / text;
}

std::optional<std::vector<Trial>> finished_block(const StudySettings& settings, const std::string& identity,
                                                 std::size_t block) {
  std::ifstream in(file_of(settings, block), std::ios::binary);
  if (!in) return std::nullopt;
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::optional<std::vector<Trial>> trials = read_block(identity, text);
  if (!trials ||
      trials->size() != settings.design.configurations.size() * static_cast<std::size_t>(settings.penetrations))
    return std::nullopt;
  return trials;
}

std::vector<std::size_t> shuffled(std::size_t count, device::Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  return order;
}

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
  device::Random random(seed_of(settings.seed, kOrder * 1000 + number, static_cast<std::uint64_t>(condition)));
  Learned learned{.depth_m = person.plant.sac_depth_m * std::clamp(1.0 + 0.2 * random.normal(), 0.5, 1.5), .from = 1};
  const std::vector<std::size_t> training = shuffled(mechanisms.size(), random);
  for (std::size_t i = 0; i < std::min<std::size_t>(kTrainingMechanisms, training.size()); ++i)
    for (std::uint64_t k = 0; k < kTrainingPenetrations; ++k)
      (void)one_penetration(settings, person, model, number, condition, mechanisms[training[i]], 100 + 10 * i + k,
                            learned);
  std::vector<Trial> trials;
  const std::vector<std::size_t> order = shuffled(mechanisms.size(), random);
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

}  // namespace

Person person_of(const StudySettings& settings, std::size_t number) noexcept {
  device::Random self(seed_of(settings.seed, kPerson, number));
  device::Random plant(seed_of(settings.seed, kPlant, number));
  return {draw(operator_ranges(), self), draw(plant_ranges(), plant)};
}

int blocks_of(const StudySettings& settings) noexcept { return settings.operators * static_cast<int>(kStudied.size()); }

int kept_blocks(const StudySettings& settings) {
  const std::string identity = identity_of(settings);
  int kept = 0;
  for (int i = 0; i < blocks_of(settings); ++i)
    kept += finished_block(settings, identity, static_cast<std::size_t>(i)) ? 1 : 0;
  return kept;
}

Result<std::vector<Trial>> run_study(const StudySettings& settings, const std::function<void(int)>& finished) {
  const Result<std::vector<Model>> models = models_of(settings);
  if (!models) return models.error();
  if (const Result<void> made = program::make_folder(settings.out / "runs", program::Readers::Anyone); !made)
    return made.error();
  const std::string identity = identity_of(settings);
  std::vector<std::vector<Trial>> blocks(static_cast<std::size_t>(blocks_of(settings)));
  std::mutex one_at_a_time;
  int done = 0;
  std::optional<Error> failed;
  program::for_each_parallel(blocks_of(settings), settings.threads, [&](int i) {
    const auto block = static_cast<std::size_t>(i);
    const std::size_t number = block / kStudied.size();
    std::optional<std::vector<Trial>> trials = finished_block(settings, identity, block);
    Result<void> written;
    if (!trials) {
      trials = run_block(settings, (*models)[number], number, kStudied[block % kStudied.size()]);
      written =
          program::write_whole_file(file_of(settings, block), block_text(identity, *trials), program::Readers::Anyone);
    }
    blocks[block] = std::move(*trials);
    const std::lock_guard lock(one_at_a_time);
    if (!written) failed = written.error();
    finished(++done);
  });
  if (failed) return *failed;
  std::vector<Trial> all;
  for (const std::vector<Trial>& block : blocks) all.insert(all.end(), block.begin(), block.end());
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
