#include "tools/study/search/judgement.h"

#include <cmath>
#include <limits>

#include "support/program/parallel.h"

namespace telepalp::study {
namespace {

constexpr std::uint64_t kSearchPart = 70'000;  // of seed_of(): beyond the parts of run/study.cpp
constexpr std::uint64_t kIntervalSeed = 1;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Interval interval_of(const std::vector<double>& values) {
  std::vector<double> known;
  for (const double value : values)
    if (std::isfinite(value)) known.push_back(value);
  return known.empty() ? Interval{kNaN, kNaN, kNaN} : bootstrap(known, kIntervalSeed);
}

/// What an operator knows after training with several mechanisms: the depth at which this sac gives way.
Learned after_training(const Plant& plant) noexcept {
  return {.depth_m = plant.sac_depth_m + plant.sac_punctures_at_N / plant.sac_N_per_m, .from = 5};
}

}  // namespace

struct Panel::Tried {
  int through = 0;
  int failed = 0;
  int noticed = 0;
  double overshoot_mm = 0.0;  // sums over the punctures
  double hand_N = 0.0;
};

void summarise(Judgement& judgement) {
  judgement.overshoot_mm = interval_of(judgement.overshoots_mm);
  judgement.hand_N = interval_of(judgement.hands_N);
}

Result<Panel> Panel::of(std::uint64_t seed, std::size_t first, int count, int threads) {
  Panel panel;
  panel.seed_ = seed;
  panel.members_.resize(static_cast<std::size_t>(count));
  StudySettings settings;
  settings.seed = seed;
  std::vector<Result<void>> made(panel.members_.size());
  program::for_each_parallel(count, threads, [&](int i) {
    Member& member = panel.members_[static_cast<std::size_t>(i)];
    member.number = first + static_cast<std::size_t>(i);
    member.person = person_of(settings, member.number);
    Result<std::shared_ptr<const tissue::TissueModel>> model = tissue::make_tissue(tissue_of(member.person.plant));
    if (model)
      member.tissue = std::move(*model);
    else
      made[static_cast<std::size_t>(i)] = model.error();
  });
  for (const Result<void>& one : made)
    if (!one) return one.error();
  return panel;
}

Panel::Tried Panel::try_out(const Member& member, const Configuration& mechanism, int penetrations) const {
  Tried tried;
  Learned learned = after_training(member.person.plant);
  for (int k = 0; k < penetrations; ++k) {
    const Result<std::unique_ptr<HeldTool>> tool = linkage_tool(mechanism, member.person.plant);
    device::Random random(seed_of(seed_, kSearchPart + member.number, static_cast<std::uint64_t>(k)));
    const Outcome out = penetrate({**tool, member.tissue, member.person.self, Condition::Both}, learned, random);
    if (!out.through) {
      ++tried.failed;
      continue;
    }
    ++tried.through;
    tried.noticed += out.noticed ? 1 : 0;
    tried.overshoot_mm += 1e3 * out.overshoot_m;
    tried.hand_N += out.most_hand_N;
  }
  return tried;
}

Judgement Panel::judge(const Configuration& mechanism, int penetrations, int threads) const {
  Judgement judgement;
  for (const Member& member : members_)
    if (const auto tool = linkage_tool(mechanism, member.person.plant); !tool) {
      judgement.refused = tool.error().what;
      return judgement;
    }
  std::vector<Tried> tried(members_.size());
  program::for_each_parallel(static_cast<int>(members_.size()), threads, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    tried[at] = try_out(members_[at], mechanism, penetrations);
  });
  int through = 0;
  int noticed = 0;
  for (const Tried& one : tried) {
    judgement.failed += one.failed;
    judgement.never += one.through == 0 ? 1 : 0;
    through += one.through;
    noticed += one.noticed;
    judgement.overshoots_mm.push_back(one.through > 0 ? one.overshoot_mm / one.through : kNaN);
    judgement.hands_N.push_back(one.through > 0 ? one.hand_N / one.through : kNaN);
  }
  judgement.noticed_share = through > 0 ? static_cast<double>(noticed) / through : 0.0;
  summarise(judgement);
  return judgement;
}

}  // namespace telepalp::study
