#include "tools/study/protocol/people.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "tools/study/figures/paper_table.h"

namespace telepalp::study {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr Interval kNobody{kNone, kNone, kNone};

/// Overshoots [mm] of each participant with each mechanism in one condition: `[person][mechanism]`.
using Overshoots = std::vector<std::vector<std::vector<double>>>;

Overshoots overshoots_of(const Protocol& protocol, const People& people, Condition condition) {
  Overshoots all(people.records.size());
  for (std::size_t person = 0; person < all.size(); ++person) {
    all[person].resize(protocol.design.configurations.size());
    for (const Attempt& attempt : people.records[person].attempts)
      if (attempt.kind == AttemptKind::Formal && attempt.trial.condition == condition && attempt.trial.outcome.through)
        all[person][attempt.trial.configuration].push_back(1e3 * attempt.trial.outcome.overshoot_m);
  }
  return all;
}

Interval interval_of(const std::vector<double>& values, std::uint64_t seed) {
  return values.empty() ? kNobody : bootstrap(values, seed);
}

double mean_or_none(const std::vector<double>& values) { return values.empty() ? kNone : mean_of(values); }

/// Of one mechanism: over the participants, or over the penetrations of the only one.
Interval cell_of(const Overshoots& all, std::size_t mechanism, std::uint64_t seed) {
  if (all.size() == 1) return interval_of(all[0][mechanism], seed);
  std::vector<double> means;
  for (const auto& person : all)
    if (!person[mechanism].empty()) means.push_back(mean_of(person[mechanism]));
  return interval_of(means, seed);
}

/// For each participant (if there is one, for each mechanism) the mean of `value(person, mechanism)` that are finite.
std::vector<double> units(const Protocol& protocol, std::size_t persons, const auto& value) {
  std::vector<double> out;
  for (std::size_t person = 0; person < persons; ++person) {
    std::vector<double> own;
    for (std::size_t i = 0; i < protocol.design.configurations.size(); ++i)
      if (const double one = value(person, i); std::isfinite(one)) own.push_back(one);
    if (persons == 1) return own;
    if (!own.empty()) out.push_back(mean_of(own));
  }
  return out;
}

void count(const People& people, PeopleCondition& out) {
  for (const PersonRecord& person : people.records)
    for (const Attempt& attempt : person.attempts) {
      if (attempt.trial.condition != out.condition) continue;
      out.held_up_s = std::max(out.held_up_s, attempt.held_up_s);
      out.broken_off += attempt.kind == AttemptKind::BrokenOff ? 1 : 0;
      if (attempt.kind != AttemptKind::Formal) continue;
      ++out.penetrations;
      out.not_through += attempt.trial.outcome.through ? 0 : 1;
      out.not_stopped += attempt.trial.outcome.through && !attempt.trial.outcome.stopped ? 1 : 0;
    }
}

std::optional<double> correlation_of(const Protocol& protocol, const PeopleCondition& condition) {
  if (!protocol.design.of_the_paper) return std::nullopt;
  std::vector<double> means;
  for (const Interval& cell : condition.cells) {
    if (!std::isfinite(cell.mean)) return std::nullopt;
    means.push_back(cell.mean);
  }
  return rank_correlation(means, paper_overshoots_mm());
}

PeopleCondition condition_of(const Protocol& protocol, const People& people, Condition condition) {
  PeopleCondition out{.condition = condition, .cells = {}, .all = kNobody, .correlation = {}};
  const Overshoots all = overshoots_of(protocol, people, condition);
  for (std::size_t i = 0; i < protocol.design.configurations.size(); ++i)
    out.cells.push_back(cell_of(all, i, protocol.seed + i));
  out.all = interval_of(
      units(protocol, all.size(), [&](std::size_t person, std::size_t i) { return mean_or_none(all[person][i]); }),
      protocol.seed);
  count(people, out);
  out.correlation = correlation_of(protocol, out);
  return out;
}

std::optional<ConditionDifference> difference(const Protocol& protocol, const People& people, Condition one) {
  const Overshoots mine = overshoots_of(protocol, people, one);
  const Overshoots sight = overshoots_of(protocol, people, Condition::Vision);
  const std::vector<double> values = units(protocol, mine.size(), [&](std::size_t person, std::size_t i) {
    return mean_or_none(mine[person][i]) - mean_or_none(sight[person][i]);
  });
  if (values.empty()) return std::nullopt;
  return ConditionDifference{.one = one, .other = Condition::Vision, .mm = bootstrap(values, protocol.seed)};
}

}  // namespace

std::filesystem::path journal_file(const std::filesystem::path& out, const std::string& participant) {
  return out / "participants" / (participant + ".csv");
}

Result<People> read_people(const Protocol& protocol, const std::filesystem::path& out) {
  std::vector<std::filesystem::path> files;
  std::error_code failed;
  for (std::filesystem::directory_iterator at(out / "participants", failed), end; !failed && at != end;
       at.increment(failed))
    if (at->path().extension() == ".csv") files.push_back(at->path());
  std::ranges::sort(files);
  People people;
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    Result<JournalText> read = parse_journal(text, file.string());
    if (!read) return read.error();
    const Result<Participant> participant = participant_of(read->head.participant);
    if (read->head.identity != identity_of(protocol) || !participant) {
      people.left_out.push_back(file.stem().string());
      continue;
    }
    const Result<Plant> plant = plant_for(protocol, *participant);
    if (!plant) return plant.error();
    const std::vector<Planned> plan = plan_of(protocol, *participant);
    const Result<std::size_t> done = done_of(plan, read->attempts, file.string());
    if (!done) return done.error();
    people.records.push_back({.participant = *participant,
                              .plant = *plant,
                              .attempts = std::move(read->attempts),
                              .done = *done,
                              .planned = plan.size()});
  }
  return people;
}

bool PeopleResult::finished() const noexcept {
  return std::ranges::all_of(people.records, [](const PersonRecord& one) { return one.done == one.planned; });
}

PeopleResult result_of(const Protocol& protocol, People people) {
  PeopleResult out{.people = std::move(people), .conditions = {}, .differences = {}};
  std::vector<Condition> conditions = protocol.conditions;
  std::ranges::sort(conditions);
  for (const Condition condition : conditions) out.conditions.push_back(condition_of(protocol, out.people, condition));
  for (const Condition one : conditions)
    if (one != Condition::Vision)
      if (const auto found = difference(protocol, out.people, one)) out.differences.push_back(*found);
  return out;
}

}  // namespace telepalp::study
