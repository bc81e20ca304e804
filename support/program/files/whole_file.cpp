#include "support/program/files/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <utility>

namespace telepalp::program {
namespace {

namespace fs = std::filesystem;

mode_t file_mode(Readers readers) { return readers == Readers::Group ? 0640 : 0644; }
mode_t folder_mode(Readers readers) { return readers == Readers::Group ? 0750 : 0755; }

Error cannot_be_written(const fs::path& file, int code) {
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return {.what = std::string("cannot be written: ") + std::strerror(code),
          .where = file.string(),
          .fix = full ? "free space on the disk of this file, or name a file on another disk"
                      : "check that the folder exists and that you may write there"};
}

/// A temporary file with a unique name. It is removed unless it is published.
class Unfinished {
 public:
  explicit Unfinished(fs::path name, mode_t mode)
      : name_(std::move(name)),
        descriptor_(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode)) {}
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (created_ && !published_) (void)::unlink(name_.c_str());
  }

  [[nodiscard]] bool created() const noexcept { return created_; }

  /// Each of these functions returns false on failure, with the reason in errno.
  [[nodiscard]] bool append(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }
  [[nodiscard]] bool publish(const fs::path& as) {
    if (::fsync(descriptor_) != 0) return false;
    if (::close(std::exchange(descriptor_, -1)) != 0) return false;
    published_ = ::rename(name_.c_str(), as.c_str()) == 0;
    return published_;
  }

 private:
  fs::path name_;
  int descriptor_;
  bool created_ = descriptor_ >= 0;
  bool published_ = false;
};

fs::path fresh_name_beside(const fs::path& file) {
  std::random_device random;
  std::array<char, 24> tail{};
  std::snprintf(tail.data(), tail.size(), ".%08x.unfinished", random());
  return file.parent_path() / ("." + file.filename().string() + tail.data());
}

/// Error if `file` is a device or a pipe: renaming a file over it would remove it for every program.
Result<void> check_replaceable(const fs::path& file) {
  struct stat at {};
  const bool is_there = ::lstat(file.c_str(), &at) == 0;
  const bool is_link = is_there && S_ISLNK(at.st_mode);
  const bool leads_somewhere = is_there && (!is_link || ::stat(file.c_str(), &at) == 0);
  if (!file.filename().empty() && (!leads_somewhere || S_ISREG(at.st_mode))) return {};
  return Error{
      .what = "is a folder, device, pipe or socket, not a file", .where = file.string(), .fix = "name another file"};
}

}  // namespace

Result<void> make_folder(const fs::path& folder, Readers readers) {
  std::error_code ignored;
  if (folder.empty() || fs::is_directory(folder, ignored)) return {};
  if (const Result<void> above = make_folder(folder.parent_path(), readers); !above) return above;
  if (folder.filename().empty() || ::mkdir(folder.c_str(), folder_mode(readers)) == 0) return {};
  const int code = errno;
  if (code == EEXIST && fs::is_directory(folder, ignored)) return {};
  return Error{
      .what = std::string("the folder cannot be made: ") + std::strerror(code),
      .where = folder.string(),
      .fix = "check that no file has this name and that you may write to the folder above, or name another folder"};
}

Result<void> write_whole_file(const fs::path& file, std::string_view bytes, Readers readers) {
  if (const Result<void> checked = check_replaceable(file); !checked) return checked;
  Unfinished unfinished(fresh_name_beside(file), file_mode(readers));
  if (!unfinished.created() || !unfinished.append(bytes) || !unfinished.publish(file))
    return cannot_be_written(file, errno);
  return {};
}

bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  std::error_code missing;
  return one == other || std::filesystem::equivalent(one, other, missing);
}

}  // namespace telepalp::program
