#include "server/access/audit_log.h"

#include <sys/stat.h>

#include <utility>
#include <vector>

#include "proto/words/numbers/utc_text.h"

namespace telepalp::access {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTime = "time=";
constexpr int kMostDamaged = 100;

/// The time of a line in the form of utc_stamp(); empty: it has none.
std::string stamp_of(std::string_view text) {
  if (!text.starts_with(kTime)) return {};
  return std::string(text.substr(kTime.size(), text.find(' ') - kTime.size()));
}

std::string counted(const char* field, std::uint64_t count) { return count == 0 ? "" : field + std::to_string(count); }

fs::path damaged_name(const fs::path& file, int number) {
  return fs::path(file.string() + ".damaged-" + std::to_string(number));
}

bool is_there(const fs::path& file) {
  std::error_code unknown;
  return fs::exists(file, unknown);
}

}  // namespace

std::string_view name(AuditEvent event) noexcept {
  switch (event) {
    case AuditEvent::Started:
      return "started";
    case AuditEvent::Stopped:
      return "stopped";
    case AuditEvent::Joined:
      return "joined";
    case AuditEvent::Left:
      return "left";
    case AuditEvent::Records:
      return "records";
    case AuditEvent::TookTouch:
      return "took-touch";
    case AuditEvent::OfferedTouch:
      return "offered-touch";
    case AuditEvent::GaveTouch:
      return "gave-touch";
    case AuditEvent::Rearmed:
      return "rearmed";
    case AuditEvent::AcceptedObject:
      return "accepted-object";
    case AuditEvent::Refused:
      return "refused";
    case AuditEvent::SignedIn:
      return "signed-in";
    case AuditEvent::SignedOut:
      return "signed-out";
    case AuditEvent::OpenedSession:
      return "opened-session";
    case AuditEvent::BroughtSession:
      return "brought-session";
    case AuditEvent::ChoseSource:
      return "chose-source";
    case AuditEvent::SetExposure:
      return "set-exposure";
    case AuditEvent::SetMicrophone:
      return "set-microphone";
    case AuditEvent::SentOut:
      return "sent-out";
    case AuditEvent::LetIn:
      return "let-in";
    case AuditEvent::TookAwayTouch:
      return "took-away-touch";
    case AuditEvent::Damaged:
      return "damaged";
  }
  return "?";
}

Result<std::unique_ptr<AuditLog>> AuditLog::open(const fs::path& file, const Say& say, std::uintmax_t most_bytes,
                                                 const std::optional<keys::AuditAnchor>& anchored) {
  if (fs::exists(file) && !fs::is_regular_file(file))
    return Error{.what = "the audit log cannot be a folder, a device or a pipe",
                 .where = file.string(),
                 .fix = "give a file by --audit"};
  std::unique_ptr<AuditLog> log(new AuditLog(file, most_bytes, say));
  Result<FileLock> lock = FileLock::take(file);
  if (!lock)
    return Error{.what = "another server writes this audit log",
                 .where = file.string(),
                 .fix = "end the other server, or give this one a log of its own by --audit"};
  log->lock_ = std::move(lock).value();
  if (const Result<void> read = log->read_end(anchored); !read) return read.error();
  if (log->open_file()) return log;
  return Error{.what = "the audit log cannot be written",
               .where = file.string(),
               .fix = "give a file by --audit, in a folder in which this program may write"};
}

/// Finds the end of the chain: that of the newest file, which may be FILE.N when the server ended between two files.
Result<void> AuditLog::read_end(const std::optional<keys::AuditAnchor>& anchored) {
  for (int number = 1; number <= kMostDamaged && damaged_.empty(); ++number)
    if (is_there(damaged_name(file_, number))) damaged_ = damaged_name(file_, number);
  std::vector<fs::path> files = keys::audit_files(file_);
  while (files.size() > 1 && fs::is_empty(files.back())) files.pop_back();
  if (files.empty()) return anchored ? is_cut(*anchored) : Result<void>{};
  keys::AuditVerifier verifier;
  bool has_anchor = true;  // an anchor in an older file was checked when that was the newest
  const Result<void> whole = verifier.add_file(files.back(), [&, this](std::string_view text) {
    if (std::string time = stamp_of(text); !time.empty()) last_time_ = std::move(time);
    if (anchored && verifier.position().lines == anchored->end.lines)
      has_anchor = verifier.position().hash == anchored->end.hash;
  });
  position_ = verifier.position();
  if (files.back() != file_) continues_ = "file=" + files.back().filename().string();
  if (!whole) return put_aside(files.back(), whole.error());
  return anchored && (!has_anchor || position_.lines < anchored->end.lines) ? is_cut(*anchored) : Result<void>{};
}

/// Raises the alarm that the log is not the one that was anchored. The log goes on.
Result<void> AuditLog::is_cut(const keys::AuditAnchor& anchored) {
  cut_ = "the audit log " + file_.string() + " was removed, cut or computed anew: it had " +
         std::to_string(anchored.end.lines) + " lines at " + anchored.time + ", the last one with the hash " +
         anchored.end.hash + ". fix: compare it with a copy";
  say_("ALARM: " + cut_);
  return {};
}

/// Renames a file whose chain is broken. The new file continues at the last line before the damage, so that the damage
/// is an event of the log and no second beginning.
Result<void> AuditLog::put_aside(const fs::path& broken, const Error& why) {
  int number = 1;
  while (is_there(damaged_name(file_, number))) ++number;
  const fs::path damaged = damaged_name(file_, number);
  std::error_code failed;
  fs::rename(broken, damaged, failed);
  if (failed)
    return Error{.what = "the audit log was altered or cut off, and it cannot be renamed to " + damaged.string() +
                         " (" + failed.message() + ")",
                 .where = broken.string(),
                 .fix = "move the audit log to another folder, or give another file by --audit"};
  damaged_ = damaged;
  continues_ = "damaged=" + damaged.filename().string();
  say_("ALARM: " + why.where + ": " + why.what + ". The file is renamed to " + damaged.string() +
       ", and the log goes on after its last unaltered line. fix: compare it with a copy; then move it to another "
       "folder");
  return {};
}

bool AuditLog::open_file() {
  const mode_t mask = ::umask(0077);  // only the owner may read the names and addresses of persons
  stream_ = {};
  stream_.rdbuf()->pubsetbuf(nullptr, 0);  // unbuffered: a line whose write failed must not come later
  stream_.open(file_, std::ios::app | std::ios::binary);
  ::umask(mask);
  if (stream_ && !lock_.is_of(file_))  // a new file, after the one before it was renamed
    if (Result<FileLock> lock = FileLock::take(file_)) lock_ = std::move(lock).value();
  return static_cast<bool>(stream_);
}

std::string AuditLog::alarm() const {
  if (!cut_.empty()) return cut_;
  if (damaged_.empty() || !is_there(damaged_)) return {};
  return "the audit log was altered or cut off: " + damaged_.string() +
         ". fix: compare it with a copy, then move it to another folder";
}

bool AuditLog::may_join(const std::string& serial, keys::WallTime now) {
  return budget_.has(serial, now.time_since_epoch());
}

bool AuditLog::is_too_often(AuditEvent event, const std::optional<std::string>& serial, keys::WallTime now) {
  if (!serial) return false;
  const bool has_room = budget_.has(*serial, now.time_since_epoch());
  if (!has_room && event != AuditEvent::Joined && event != AuditEvent::Left) return true;
  budget_.spend(*serial);
  return false;
}

void AuditLog::note(AuditEvent event, const std::optional<std::string>& serial, const std::string& text,
                    keys::WallTime now) {
  if (is_too_often(event, serial, now)) return void(++left_out_);
  begin_next_file();
  begin_file(now);
  const std::string more = counted(" left-out=", left_out_) + counted(" not-written=", not_written_ - missing_said_);
  if (continues_.empty() && write("event=" + std::string(name(event)) + (text.empty() ? "" : " ") + text + more, now)) {
    left_out_ = 0;
    missing_said_ = not_written_;
    return;
  }
  if (++not_written_ == missing_said_ + 1)
    say_("ALARM: the audit log " + file_.string() +
         " cannot be written. fix: free space on its disk, or check the disk");
}

/// Writes the first line of a file that continues another one: the name and the end of the previous file.
void AuditLog::begin_file(keys::WallTime now) {
  if (continues_.empty()) return;
  const std::string text =
      "event=" + std::string(keys::kAuditContinues) + " " + keys::audit_continuation(position_) + " " + continues_;
  if (write(text, now)) continues_.clear();
}

void AuditLog::begin_next_file() {
  std::error_code failed;
  if (fs::file_size(file_, failed) < most_bytes_ || failed) return;
  const fs::path full = keys::next_audit_file(file_);
  fs::rename(file_, full, failed);
  if (!failed) {
    continues_ = "file=" + full.filename().string();
    if (!open_file()) failed = std::make_error_code(std::errc::io_error);
  }
  if (failed && !std::exchange(rename_failed_, true))
    say_("ALARM: the audit log " + file_.string() + " cannot be renamed to " + full.string() + " (" + failed.message() +
         "). fix: check that this program may write to the folder");
}

/// Writes the line of `text`. False: the disk is full.
bool AuditLog::write(const std::string& text, keys::WallTime now) {
  const std::string clock = utc_stamp(now);
  std::string time = std::max(clock, last_time_);
  keys::AuditPosition next = position_;
  const std::string line =
      keys::audit_line(next, std::string(kTime) + time + " " + text + (time == clock ? "" : " clock=" + clock));
  if (!append(line)) return false;
  position_ = next;
  last_time_ = std::move(time);
  return true;
}

/// On a full disk a part of the line may have been written. It is removed, so that the next line follows the last whole
/// one.
bool AuditLog::append(const std::string& line) {
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(file_, unknown);
  stream_.clear();
  stream_ << line << std::flush;
  if (stream_) return true;
  std::error_code failed;
  if (!unknown) fs::resize_file(file_, bytes, failed);
  return false;
}

}  // namespace telepalp::access
