#include "tools/study/page/results.h"

#include <algorithm>

#include "haptic_station/mechanism/held_linkage.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::study {
namespace {

constexpr int kPermutations = 1000;

struct Sum {
  double sum = 0.0;
  int count = 0;
  void add(double value) noexcept {
    sum += value;
    ++count;
  }
  [[nodiscard]] double mean() const noexcept { return count > 0 ? sum / count : 0.0; }
};

/// Penetrations of one operator with one mechanism, in one condition.
using OvershootCells = std::vector<std::vector<Sum>>;

OvershootCells cells_of(const StudySettings& settings, const std::vector<Trial>& trials, Condition condition) {
  OvershootCells cells(static_cast<std::size_t>(settings.operators),
                       std::vector<Sum>(settings.design.configurations.size()));
  for (const Trial& trial : trials)
    if (trial.condition == condition && trial.outcome.through)
      cells[trial.person][trial.configuration].add(1e3 * trial.outcome.overshoot_m);
  return cells;
}

/// Operators who came through with each mechanism in each condition.
std::vector<bool> complete_operators(const std::array<OvershootCells, kStudied.size()>& all) {
  std::vector<bool> complete(all[0].size(), true);
  for (const OvershootCells& cells : all)
    for (std::size_t person = 0; person < cells.size(); ++person)
      for (const Sum& sum : cells[person]) complete[person] = complete[person] && sum.count > 0;
  return complete;
}

void count(const std::vector<Trial>& trials, ConditionResult& out) {
  Sum noticed;
  for (const Trial& trial : trials) {
    if (trial.condition != out.condition) continue;
    out.not_through += trial.outcome.through ? 0 : 1;
    out.not_stopped += trial.outcome.through && !trial.outcome.stopped ? 1 : 0;
    if (trial.outcome.through) noticed.add(trial.outcome.noticed ? 1.0 : 0.0);
  }
  out.noticed_share = noticed.mean();
}

void summarise(const StudySettings& settings, const OvershootCells& cells, const std::vector<bool>& complete,
               ConditionResult& out) {
  std::vector<double> of_operators;
  for (std::size_t person = 0; person < cells.size(); ++person) {
    if (!complete[person]) continue;
    out.by_operator.emplace_back();
    for (const Sum& sum : cells[person]) out.by_operator.back().push_back(sum.mean());
    of_operators.push_back(mean_of(out.by_operator.back()));
  }
  out.all = bootstrap(of_operators, settings.seed);
  for (std::size_t i = 0; i < settings.design.configurations.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<double>& person : out.by_operator) values.push_back(person[i]);
    out.cells.push_back(bootstrap(values, settings.seed + i));
  }
}

Correlation correlation_of(const ConditionResult& result) {
  const std::vector<double> paper = paper_overshoots_mm();
  std::vector<double> means;
  for (const Interval& cell : result.cells) means.push_back(cell.mean);
  std::vector<double> single;
  for (const std::vector<double>& person : result.by_operator) single.push_back(rank_correlation(person, paper));
  const auto [least, most] = std::minmax_element(single.begin(), single.end());
  Correlation out{.of_means = rank_correlation(means, paper), .least = *least, .most = *most};
  out.median = median_of(single);
  return out;
}

Interval difference(const ConditionResult& one, const ConditionResult& other, std::uint64_t seed) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < one.by_operator.size(); ++i)
    differences.push_back(mean_of(one.by_operator[i]) - mean_of(other.by_operator[i]));
  return bootstrap(differences, seed);
}

void compare_with_paper(const StudySettings& settings, StudyResult& out) {
  for (std::size_t i = 0; i < kStudied.size(); ++i) out.correlations[i] = correlation_of(out.conditions[i]);
  out.ceiling_penetrations = noise_ceiling(20.0, settings.seed);
  out.ceiling_subjects = noise_ceiling(4.0, settings.seed);
  std::vector<double> levers;
  for (const Configuration& one : settings.design.configurations)
    levers.push_back(-mechanism::lever_of(one.bar).length_m);
  out.lever_alone = rank_correlation(levers, paper_overshoots_mm());
  out.patterns = patterns_of(out.conditions[2].by_operator, settings.seed);
  out.effects = effects_of(out.conditions[2].by_operator, kPermutations, settings.seed);
}

}  // namespace

Result<StudyResult> result_of(const StudySettings& settings, const std::vector<Trial>& trials, const Check& check) {
  StudyResult out;
  out.check = check;
  std::array<OvershootCells, kStudied.size()> cells;
  for (std::size_t i = 0; i < kStudied.size(); ++i) cells[i] = cells_of(settings, trials, kStudied[i]);
  const std::vector<bool> complete = complete_operators(cells);
  out.left_out = static_cast<int>(std::count(complete.begin(), complete.end(), false));
  if (out.left_out == settings.operators)
    return Error{.what = "each operator failed to puncture the sac with some mechanism",
                 .where = settings.design.name,
                 .fix = "see trials.csv; give mechanisms whose needle reaches the sac, or more penetrations"};
  for (std::size_t i = 0; i < kStudied.size(); ++i) {
    out.conditions[i].condition = kStudied[i];
    count(trials, out.conditions[i]);
    summarise(settings, cells[i], complete, out.conditions[i]);
  }
  out.force_against_vision = difference(out.conditions[0], out.conditions[1], settings.seed);
  out.both_against_vision = difference(out.conditions[2], out.conditions[1], settings.seed);
  std::vector<Sum> drops(settings.design.configurations.size());
  for (const Trial& trial : trials)
    if (trial.condition == Condition::Both) drops[trial.configuration].add(trial.outcome.hand_drop_N);
  for (const Sum& drop : drops) out.hand_drop_N.push_back(drop.mean());
  if (settings.design.of_the_paper) compare_with_paper(settings, out);
  return out;
}

}  // namespace telepalp::study
