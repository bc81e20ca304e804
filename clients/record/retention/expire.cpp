#include "clients/record/retention/expire.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "clients/record/recorder_lock.h"
#include "proto/keys/audit_text.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "proto/words/numbers/utc_text.h"

namespace telepalp::record {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSession = ".mcap";
constexpr std::string_view kUnfinished = ".mcap.partial";
constexpr std::string_view kUnfinishedCopy = ".unfinished";  // as program::write_whole_file() names one
constexpr const char* kCannotBeDeleted = "cannot be deleted";

WallTime wall_time(std::uint64_t ns) {
  return WallTime(std::chrono::duration_cast<WallTime::duration>(
      std::chrono::nanoseconds(static_cast<std::int64_t>(std::min<std::uint64_t>(ns, INT64_MAX)))));
}

/// The patient's consents, to the recording and to that of what is said.
std::string consents_of(const wire::SessionInfo& session) {
  return session.voice_consent.empty() ? session.consent : session.consent + "; " + session.voice_consent;
}

/// The facts of a finished session, by its index.
Result<RecordedSession> facts_of_finished(const fs::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  return RecordedSession{file.filename().string(), wall_time(reader->summary().statistics.message_start_time),
                         consents_of(*session)};
}

/// The facts of an unfinished session, by its first message and the record before it.
Result<RecordedSession> facts_of_unfinished(const fs::path& file) {
  Result<wire::McapStreamReader> stream = wire::McapStreamReader::open(file);
  if (!stream) return stream.error();
  const auto first = stream->next();
  if (!first) return first.error();
  RecordedSession facts{file.filename().string(), {}, {}};
  if (*first) facts.began = wall_time((**first).record.log_time);
  for (const wire::mcap::Metadata& metadata : stream->metadata())
    if (metadata.name == wire::kSessionMetadata) facts.consent = consents_of(wire::session_info(metadata));
  return facts;
}

FoundSession look_at(const fs::path& file, const RetentionRules& rules, WallTime now) {
  std::error_code unknown;
  FoundSession found{.file = file, .bytes = fs::file_size(file, unknown), .facts = {}, .judgement = {}, .problem = {}};
  const bool is_finished = file.string().ends_with(kSession);
  Result<RecordedSession> facts = is_finished ? facts_of_finished(file) : facts_of_unfinished(file);
  // The date and the consent of a damaged file cannot be trusted, but the list of withdrawn consents may name the file.
  found.facts = facts ? *facts : RecordedSession{file.filename().string(), {}, {}};
  const Result<Judgement> judged = judge(found.facts, rules, now);
  if (judged && (facts || judged->expired))
    found.judgement = *judged;
  else
    found.problem = facts ? judged.error() : facts.error();
  return found;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Deletes `file` if it exists, and writes the folder to the disk, so that the file does not come back after a crash.
Result<void> unlink_file(const fs::path& file) {
  if (::unlink(file.c_str()) != 0 && errno != ENOENT)
    return Error{.what = std::string(kCannotBeDeleted) + ": " + std::strerror(errno),
                 .where = file.string(),
                 .fix = "check the folder and your permissions, then run the command again"};
  const int descriptor = ::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    (void)::fsync(descriptor);
    ::close(descriptor);
  }
  return {};
}

/// Deletes the notes on `session`, and copies of them that a server left unfinished when it was killed.
Result<void> unlink_notes(const fs::path& session) {
  const fs::path notes = wire::notes_file(session);
  const std::string beginning = "." + notes.filename().string() + ".";
  std::vector<fs::path> files{notes};
  std::error_code problem;
  for (fs::directory_iterator entry(folder_of(session), problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(beginning) && name.ends_with(kUnfinishedCopy)) files.push_back(entry->path());
  }
  for (const fs::path& file : files)
    if (Result<void> gone = unlink_file(file); !gone) return gone;
  return {};
}

std::string described(const FoundSession& session) {
  return "file=" + keys::audit_text(session.facts.file) + " bytes=" + std::to_string(session.bytes) +
         " recorded=" + utc_stamp(session.facts.began) + " consent=" + keys::audit_text(session.facts.consent) +
         " reason=" + keys::audit_text(session.judgement.reason);
}

}  // namespace

Result<Survey> survey(const fs::path& folder, const RetentionRules& rules, WallTime now) {
  std::error_code failed;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    if ((name.ends_with(kSession) || name.ends_with(kUnfinished)) &&
        fs::is_regular_file(entry->symlink_status(unknown)))
      files.push_back(entry->path());
  }
  if (failed)
    return Error{.what = "the folder cannot be read: " + failed.message(),
                 .where = folder.string(),
                 .fix = "give the folder of the recordings, as in telepalp-server --record-dir"};
  std::ranges::sort(files);
  Survey found;
  for (const fs::path& file : files) found.sessions.push_back(look_at(file, rules, now));
  for (const std::string& line : rules.withdrawn)
    if (std::ranges::none_of(found.sessions, [&](const FoundSession& session) { return names(line, session.facts); }))
      found.unmatched.push_back(line);
  return found;
}

Result<void> remove(const FoundSession& session, RetentionLog& log, const std::string& by) {
  const Result<RecorderLock> lock = RecorderLock::take(session.file, kCannotBeDeleted);
  if (!lock) return lock.error();
  const std::string what = described(session);
  if (const Result<void> noted = log.note("delete by=" + keys::audit_text(by) + " " + what); !noted) return noted;
  // The notes first: if the computer stops in between, the next run finds the session again; it would not find notes
  // whose session is gone.
  Result<void> gone = unlink_notes(session.file);
  if (gone) gone = unlink_file(session.file);
  const std::string outcome =
      gone ? "deleted " + what : "not-deleted " + what + " why=" + keys::audit_text(gone.error().what);
  const Result<void> noted = log.note(outcome);
  return gone ? noted : gone;
}

}  // namespace telepalp::record
