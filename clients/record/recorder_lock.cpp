#include "clients/record/recorder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace telepalp::record {
namespace {

Error system_error(const std::filesystem::path& file, const std::string& failed) {
  return {.what = failed + ": " + std::strerror(errno),
          .where = file.string(),
          .fix = "check the folder and your permissions, then run the command again"};
}

}  // namespace

Result<RecorderLock> RecorderLock::take(const std::filesystem::path& file, const std::string& failed) {
  RecorderLock lock(::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  if (lock.descriptor_ < 0) return system_error(file, failed);
  if (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) return system_error(file, failed);
    return Error{
        .what = "is still being recorded",
        .where = file.string(),
        .fix =
            "end the recording first: press Ctrl-C at telepalp-record, or End recording in the technician's view of "
            "the web page"};
  }
  if (lock.is_of(file)) return lock;
  return Error{.what = "no longer exists: the recorder has just completed the file and given it its final name",
               .where = file.string(),
               .fix = "run the command again; if it names the file, give the final name"};
}

RecorderLock::RecorderLock(RecorderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

RecorderLock::~RecorderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// False when the recorder has given the file its final name after it was opened here.
bool RecorderLock::is_of(const std::filesystem::path& file) const {
  struct stat locked {};
  struct stat named {};
  return ::fstat(descriptor_, &locked) == 0 && ::lstat(file.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
         locked.st_dev == named.st_dev;
}

}  // namespace telepalp::record
