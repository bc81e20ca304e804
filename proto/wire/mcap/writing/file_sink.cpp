#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "proto/wire/mcap/format/byte_sink.h"
#include "proto/wire/mcap/writing/output_file.h"

namespace telepalp::wire::mcap {
namespace {

std::filesystem::path partial(const std::filesystem::path& name) { return name.string() + ".partial"; }

std::filesystem::path folder_of(const std::filesystem::path& name) {
  return name.has_parent_path() ? name.parent_path() : std::filesystem::path(".");
}

void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);  // errors are ignored: some file systems do not support it
  ::close(descriptor);
}

class FileSink final : public ByteSink {
 public:
  FileSink(std::filesystem::path name, int descriptor) noexcept : name_(std::move(name)), descriptor_(descriptor) {}
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;
  ~FileSink() override {  // an unpublished file stays as NAME.partial
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] Result<void> write(std::uint64_t offset, std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return failure(errno, "the messages written before are stored");
      bytes.remove_prefix(static_cast<std::size_t>(written));
      offset += static_cast<std::uint64_t>(written);
    }
    return {};
  }
  void cut(std::uint64_t size) noexcept override {
    // If this fails too, the partial record stays at the end of the file, where readers expect damage.
    (void)!::ftruncate(descriptor_, static_cast<off_t>(size));
  }
  [[nodiscard]] Result<void> publish() override;
  void discard() noexcept override {
    if (descriptor_ < 0) return;
    ::close(std::exchange(descriptor_, -1));
    (void)::unlink(partial(name_).c_str());
  }

 private:
  [[nodiscard]] Error failure(int code, const std::string& consequence) const;

  std::filesystem::path name_;
  int descriptor_;
};

Error FileSink::failure(int code, const std::string& consequence) const {
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  const std::string folder = folder_of(name_).string();
  return {.what = std::string("cannot be written: ") + std::strerror(code) + "; " + consequence,
          .where = partial(name_).string(),
          .fix = full ? "free space in " + folder + ", or record to another disk" : "check the disk under " + folder};
}

Result<void> FileSink::publish() {
  const bool synced = ::fsync(descriptor_) == 0;
  const int sync_error = errno;
  const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
  constexpr const char* kInDoubt = "the last messages may be lost";
  if (!synced) return failure(sync_error, kInDoubt);
  if (!closed) return failure(errno, kInDoubt);
  if (rename_without_replacing(partial(name_), name_) != 0)
    return Error{
        .what = "is complete but cannot be renamed to " + name_.filename().string() + ": " + std::strerror(errno),
        .where = partial(name_).string(),
        .fix = "rename it by hand to a name that is free"};
  sync_folder(folder_of(name_));
  return {};
}

}  // namespace

int rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;
  return ::rename(from.c_str(), to.c_str());
}

Result<std::unique_ptr<ByteSink>> new_file(const std::filesystem::path& name) {
  std::error_code code;
  if (std::filesystem::exists(name, code))
    return Error{
        .what = "exists already", .where = name.string(), .fix = "choose another name, or move this file away"};
  const int descriptor = ::open(partial(name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0640);
  if (descriptor >= 0) {
    (void)::flock(descriptor, LOCK_EX | LOCK_NB);  // errors are ignored: some file systems do not support it
    return std::unique_ptr<ByteSink>(std::make_unique<FileSink>(name, descriptor));
  }
  if (errno == EEXIST)
    return Error{.what = "exists already: a recording that was cut off, or a recording that is running",
                 .where = partial(name).string(),
                 .fix = "choose another name. If no recorder is running, telepalp-record repair " +
                        partial(name).string() + " mends the file"};
  return Error{.what = std::string("cannot be created: ") + std::strerror(errno),
               .where = name.string(),
               .fix = "check that the folder exists and may be written"};
}

}  // namespace telepalp::wire::mcap
