#include "clients/record/unfinished.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "proto/wire/mcap/writing/output_file.h"
#include "proto/words/counted.h"

namespace telepalp::record {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartial = ".partial";

fs::path finished_name(const fs::path& partial) {
  const std::string name = partial.string();
  return name.substr(0, name.size() - kPartial.size());
}

Error cannot_be_finished(const fs::path& file, const std::string& why) {
  return {.what = "the recording cannot be completed: " + why,
          .where = file.string(),
          .fix = "check the folder and your permissions"};
}

/// Holds the lock that a recorder holds on its file while it writes.
class Lock {
 public:
  [[nodiscard]] static Result<Lock> take(const fs::path& partial) {
    Lock lock(::open(partial.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (lock.descriptor_ < 0) return cannot_be_finished(partial, std::strerror(errno));
    if (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0) return lock;
    if (errno != EWOULDBLOCK) return cannot_be_finished(partial, std::strerror(errno));
    return Error{
        .what = "is still being recorded",
        .where = partial.string(),
        .fix =
            "end the recording first: press Ctrl-C at telepalp-record, or End recording in the technician's view of "
            "the web page"};
  }
  Lock(Lock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Lock& operator=(Lock&&) = delete;
  ~Lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  /// False when the recorder has meanwhile given the file its final name.
  [[nodiscard]] bool is_of(const fs::path& partial) const {
    struct stat locked {};
    struct stat named {};
    return ::fstat(descriptor_, &locked) == 0 && ::lstat(partial.c_str(), &named) == 0 &&
           locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
  }

 private:
  explicit Lock(int descriptor) noexcept : descriptor_(descriptor) {}
  int descriptor_;
};

/// True if the partial file holds nothing that the finished one lacks.
bool holds_nothing_more(const RepairReport& report) {
  return report.only_end_is_missing || (report.damages.empty() && report.lost == 0U);
}

}  // namespace

std::optional<fs::path> unfinished(const fs::path& asked) {
  std::error_code ignored;
  if (asked.string().ends_with(kPartial) && fs::is_regular_file(asked, ignored)) return asked;
  const fs::path partial = asked.string() + std::string(kPartial);
  if (fs::exists(asked, ignored) || !fs::is_regular_file(partial, ignored)) return std::nullopt;
  return partial;
}

Result<RepairReport> finish(const fs::path& partial) {
  const fs::path name = finished_name(partial);
  std::error_code ignored;
  if (fs::exists(name, ignored))
    return Error{
        .what = "the recording cannot be completed: " + name.filename().string() + " exists already",
        .where = partial.string(),
        .fix =
            "move one of the two files away, or copy the readable messages to another file: telepalp-record repair " +
            partial.string() + " --out OTHER.mcap"};
  const Result<Lock> lock = Lock::take(partial);
  if (!lock) return lock.error();
  if (!lock->is_of(partial))
    return Error{.what = "no longer exists: the recorder has just completed the file and given it its final name",
                 .where = partial.string(),
                 .fix = "use " + name.string()};
  const fs::path made =
      name.string() + ".finishing";  // under the lock, so a file with this name is the rest of a crash
  fs::remove(made, ignored);
  fs::remove(made.string() + std::string(kPartial), ignored);
  Result<RepairReport> report = repair(partial, made);
  if (!report) return report;
  if (wire::mcap::rename_without_replacing(report->file, name) != 0)
    return cannot_be_finished(name, std::strerror(errno));
  report->file = name;
  if (holds_nothing_more(*report)) fs::remove(partial, ignored);
  return report;
}

std::string in_words(const RepairReport& finished) {
  std::string text = finished.file.string() + " was not completed by its recorder; the file is complete now, with " +
                     counted(finished.messages, "message", "messages");
  if (!holds_nothing_more(finished))
    text += "; " + counted(finished.damages.size(), "place was", "places were") +
            " damaged, so the recorder's own file is kept, too: " + finished.file.string() + std::string(kPartial);
  return text;
}

}  // namespace telepalp::record
