#pragma once

#include <optional>

#include "tools/study/figures/statistics.h"
#include "tools/study/protocol/journal.h"

namespace telepalp::study {

/// What one participant has done.
struct PersonRecord {
  Participant participant;
  Plant plant;
  std::vector<Attempt> attempts;
  std::size_t done = 0;
  std::size_t planned = 0;
};

/// The journal of a participant in the folder of a study.
[[nodiscard]] std::filesystem::path journal_file(const std::filesystem::path& out, const std::string& participant);

/// All participants of a folder, by name.
struct People {
  std::vector<PersonRecord> records;
  std::vector<std::string> left_out;  ///< journals of another protocol
};
/// Error: a journal is damaged.
[[nodiscard]] Result<People> read_people(const Protocol& protocol, const std::filesystem::path& out);

/// Overshoots in one condition [mm].
struct PeopleCondition {
  Condition condition = Condition::Both;
  /// Mean overshoot with each mechanism; NaN where nobody has punctured the sac with it yet. The interval is over the
  /// participants; if there is only one, over the penetrations.
  std::vector<Interval> cells;
  Interval
      all;  ///< mean over the mechanisms; the interval is over the participants; if there is only one, the mechanisms
  int penetrations = 0;
  int not_through = 0;  ///< penetrations without a puncture; left out of the means
  int not_stopped = 0;  ///< the tip did not stop in time; they count with its last place
  int broken_off = 0;
  double held_up_s = 0.0;             ///< longest time that a penetration lost because a program was late
  std::optional<double> correlation;  ///< rank correlation with S4's Table 2; nullopt: not all its mechanisms are done
};

/// How much longer or shorter the overshoot is in one condition than in another, with the same mechanisms [mm].
struct ConditionDifference {
  Condition one = Condition::Both;
  Condition other = Condition::Vision;
  Interval mm;  ///< over the participants; if there is only one, over the mechanisms
};

struct PeopleResult {
  People people;
  std::vector<PeopleCondition> conditions;       ///< in the order of the enumeration
  std::vector<ConditionDifference> differences;  ///< to Vision, as far as both were tried
  [[nodiscard]] bool finished() const noexcept;
};
/// Training runs and attempts that were broken off count in no overshoot.
[[nodiscard]] PeopleResult result_of(const Protocol& protocol, People people);

/// A table for a terminal.
[[nodiscard]] std::string people_text(const Protocol& protocol, const PeopleResult& result);
[[nodiscard]] std::string people_json(const Protocol& protocol, const PeopleResult& result);
/// The page, with plots; self-contained, without scripts.
[[nodiscard]] std::string people_html(const Protocol& protocol, const PeopleResult& result);
/// All formal penetrations as CSV, in the form of a simulated study's trials.csv with two more columns: the
/// participant's name, and the hand.
[[nodiscard]] std::string people_csv(const Protocol& protocol, const PeopleResult& result);

}  // namespace telepalp::study
