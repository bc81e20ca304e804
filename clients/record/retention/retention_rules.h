#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::record {

using WallTime = std::chrono::system_clock::time_point;

/// How long the recordings of a folder may be kept.
struct RetentionRules {
  std::optional<std::chrono::days> keep;  ///< from a session's beginning; nullopt: without end
  std::vector<std::string> withdrawn;     ///< consents, or names of session files, that were withdrawn
};

/// The facts of a session on which its retention depends.
struct RecordedSession {
  std::string file;  ///< name of the file, without its folder
  WallTime began;
  std::string consent;  ///< as stated to the recorder; empty: not stated
};

/// Whether a session is to be deleted, and the rule that says so.
struct Judgement {
  bool expired = false;
  std::string reason;  ///< such as "its consent was withdrawn: form 4711", or "until 2027-03-01 by its consent"
};

/// The entries of a list of withdrawn consents: its lines without comments (from '#' on), blanks around them and empty
/// lines.
[[nodiscard]] std::vector<std::string> withdrawn_in(std::string_view text);

/// True if the list's entry `line` withdraws this session: it is the session's file name, or stands in its consent as
/// whole words ("form 471" does not withdraw "form 4711").
[[nodiscard]] bool names(std::string_view line, const RecordedSession& session);

/// When a consent such as "form 4711, until 2027-03-01" ends: the first instant after that day, in UTC. nullopt: the
/// consent states no date. Error: there is no such day in the calendar.
[[nodiscard]] Result<std::optional<WallTime>> end_of_consent(std::string_view consent);

/// Judges a session at `now`. It has expired if its consent is withdrawn, the date in its consent is over, or it is
/// older than `rules.keep`. Error: it cannot be judged, because the consent's date does not exist, or the session's
/// date is before 2015 or more than a day after `now`.
[[nodiscard]] Result<Judgement> judge(const RecordedSession& session, const RetentionRules& rules, WallTime now);

}  // namespace telepalp::record
