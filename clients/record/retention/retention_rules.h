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

/// What the rules look at in a session.
struct RecordedSession {
  std::string file;  ///< name of the file, without its folder
  WallTime began;
  std::string consent;  ///< as stated to the recorder; empty: not stated
};

/// The end of a session's time, and why.
struct Judgement {
  bool expired = false;
  std::string reason;  ///< "its consent was withdrawn: form 4711", "until 2027-03-01 by its consent"
};

/// The lines of a list of withdrawn consents, without comments (from '#' on) and empty lines.
[[nodiscard]] std::vector<std::string> withdrawn_in(std::string_view text);

/// True if `line` is the session's file name, or stands in its consent as whole words: "form 471" is not in "form
/// 4711".
[[nodiscard]] bool names(std::string_view line, const RecordedSession& session);

/// The first instant after the date in "… until 2027-03-01 …", in UTC; nullopt: the consent names no such date. Error:
/// the date does not exist.
[[nodiscard]] Result<std::optional<WallTime>> end_of_consent(std::string_view consent);

/// Judges a session at `now`. The earliest of three ends counts: the consent is withdrawn, the date of the consent is
/// over, the session is older than `rules.keep`. Error: it cannot be judged, because the consent's date does not exist
/// or the session's date is before 2015 or more than a day after `now`.
[[nodiscard]] Result<Judgement> judge(const RecordedSession& session, const RetentionRules& rules, WallTime now);

}  // namespace telepalp::record
