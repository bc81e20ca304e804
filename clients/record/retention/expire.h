#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "clients/record/retention/retention_log.h"
#include "clients/record/retention/retention_rules.h"

namespace telepalp::record {

/// A session file of a folder, finished or not.
struct FoundSession {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  RecordedSession facts;
  Judgement judgement;
  std::optional<Error> problem;  ///< why it cannot be judged; then it is kept
};

/// The sessions of a folder, in order of their names, each judged by the rules.
struct Survey {
  std::vector<FoundSession> sessions;
  std::vector<std::string> unmatched;  ///< lines of RetentionRules::withdrawn that name no session of the folder
};

/// Judges each NAME.mcap and NAME.mcap.partial of `folder`, but not of its sub-folders. It reads no more of a session
/// than the beginning and the index. Error: the folder cannot be read.
[[nodiscard]] Result<Survey> survey(const std::filesystem::path& folder, const RetentionRules& rules, WallTime now);

/// Deletes the session and the file of notes beside it, and writes a line to `log` before and after. `by`: who deletes
/// it, for the log. Error: a recorder still writes the session, or the log cannot be written, so nothing is deleted; or
/// a file cannot be deleted.
[[nodiscard]] Result<void> remove(const FoundSession& session, RetentionLog& log, const std::string& by);

}  // namespace telepalp::record
