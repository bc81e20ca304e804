#include "clients/record/retention/retention_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "proto/words/numbers/utc_text.h"

namespace telepalp::record {
namespace {

Error cannot_write(const std::filesystem::path& file, const std::string& why) {
  return {.what = "the log of deletions cannot be written: " + why,
          .where = file.string(),
          .fix =
              "check the folder and your permissions, or give another file by --audit; nothing is deleted without a "
              "line in this log"};
}

}  // namespace

Result<RetentionLog> RetentionLog::open(const std::filesystem::path& file) {
  RetentionLog log(file, ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (log.descriptor_ < 0) return cannot_write(file, std::strerror(errno));
  if (::flock(log.descriptor_, LOCK_EX | LOCK_NB) != 0)
    return errno == EWOULDBLOCK ? cannot_write(file, "another telepalp-record expire has it open")
                                : cannot_write(file, std::strerror(errno));
  keys::AuditVerifier verifier;
  if (const Result<void> whole = verifier.add_file(file); !whole)
    return Error{.what = whole.error().what,
                 .where = whole.error().where,
                 .fix = "compare the log with a copy; then move it to another folder. Nothing was deleted"};
  log.position_ = verifier.position();
  return log;
}

RetentionLog::RetentionLog(RetentionLog&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      position_(std::move(other.position_)) {}

RetentionLog::~RetentionLog() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> RetentionLog::note(const std::string& event) {
  keys::AuditPosition next = position_;
  const std::string line =
      keys::audit_line(next, "time=" + utc_stamp(std::chrono::system_clock::now()) + " event=" + event);
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  const ssize_t written = ::write(descriptor_, line.data(), line.size());
  if (written != static_cast<ssize_t>(line.size()) || ::fdatasync(descriptor_) != 0) {
    const std::string why = written < 0 ? std::strerror(errno) : "no space left on the disk";
    (void)::ftruncate(descriptor_, before);  // a part of a line would break the chain
    return cannot_write(file_, why);
  }
  position_ = next;
  return {};
}

}  // namespace telepalp::record
