#include "server/access/audit_log.h"

#include <sys/stat.h>

#include <ctime>
#include <optional>
#include <utility>

namespace telepalp::access {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostStrangers = 20;
constexpr std::uint64_t kMostOthers = 200;
constexpr std::chrono::seconds kRefusalsWithin{10};

/// The end of the chain in `file`; nullopt: it is broken, or cut off within a line.
std::optional<keys::AuditPosition> end_of_chain(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  keys::AuditVerifier verifier;
  for (std::string line; std::getline(stream, line);)
    if (stream.eof() || !verifier.add(line)) return std::nullopt;
  return verifier.position();
}

/// "2026-11-22T00:12:33Z"
std::string stamp(keys::WallTime now) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::string counted(const char* field, std::uint64_t count) { return count == 0 ? "" : field + std::to_string(count); }

fs::path free_name(const fs::path& file) {
  int number = 1;
  const auto name = [&] { return fs::path(file.string() + ".damaged-" + std::to_string(number)); };
  for (std::error_code unknown; fs::exists(name(), unknown);) ++number;
  return name();
}

/// Renames a log whose chain is broken, so that no new line follows a broken one.
Result<void> put_aside(const fs::path& file, const std::function<void(const std::string&)>& say) {
  const fs::path damaged = free_name(file);
  std::error_code failed;
  fs::rename(file, damaged, failed);
  if (failed)
    return Error{.what = "the audit log was altered or cut off, and it cannot be renamed to " + damaged.string() +
                         " (" + failed.message() + ")",
                 .where = file.string(),
                 .fix = "move the audit log to another folder, or give another file by --audit"};
  say("the audit log " + file.string() + " was altered or cut off; it is renamed to " + damaged.string() +
      ", and a new log begins. fix: find the altered line: telepalp-keys audit-verify " + damaged.string());
  return {};
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
  }
  return "?";
}

Result<std::unique_ptr<AuditLog>> AuditLog::open(const fs::path& file,
                                                 const std::function<void(const std::string&)>& say) {
  keys::AuditPosition position;
  if (fs::exists(file) && !fs::is_regular_file(file))
    return Error{.what = "the audit log cannot be a folder, a device or a pipe",
                 .where = file.string(),
                 .fix = "give a file by --audit"};
  if (fs::exists(file)) {
    const std::optional<keys::AuditPosition> end = end_of_chain(file);
    if (end)
      position = *end;
    else if (const Result<void> aside = put_aside(file, say); !aside)
      return aside.error();
  }
  const mode_t mask = ::umask(0077);  // only the owner may read the names and addresses of persons
  std::unique_ptr<AuditLog> log(new AuditLog(file, position, say));
  ::umask(mask);
  if (!log->stream_)
    return Error{.what = "the audit log cannot be written",
                 .where = file.string(),
                 .fix = "give a file by --audit, in a folder in which this program may write"};
  return log;
}

AuditLog::AuditLog(fs::path file, keys::AuditPosition position, std::function<void(const std::string&)> say)
    : file_(std::move(file)), position_(std::move(position)), say_(std::move(say)) {
  stream_.rdbuf()->pubsetbuf(nullptr, 0);  // unbuffered: a line whose write failed must not come later
  stream_.open(file_, std::ios::app | std::ios::binary);
}

bool AuditLog::is_too_often(AuditEvent event, const std::string& text, keys::WallTime now) {
  if (event != AuditEvent::Refused) return false;
  if (now - refusals_since_ > kRefusalsWithin) {
    refusals_since_ = now;
    strangers_ = others_ = 0;
  }
  return text.starts_with("who=stranger") ? ++strangers_ > kMostStrangers : ++others_ > kMostOthers;
}

void AuditLog::note(AuditEvent event, const std::string& text, keys::WallTime now) {
  if (is_too_often(event, text, now)) return void(++unsaid_);
  const std::string more = counted(" also-refused=", unsaid_) + counted(" not-written=", not_written_ - missing_said_);
  keys::AuditPosition next = position_;
  const std::string line = keys::audit_line(
      next, "time=" + stamp(now) + " event=" + std::string(name(event)) + (text.empty() ? "" : " ") + text + more);
  if (append(line)) {
    position_ = next;
    unsaid_ = 0;
    missing_said_ = not_written_;
    return;
  }
  if (++not_written_ == missing_said_ + 1)
    say_("ALARM: the audit log " + file_.string() +
         " cannot be written. fix: free space on its disk, or check the disk");
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
