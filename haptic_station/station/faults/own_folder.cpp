#include "haptic_station/station/faults/own_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace telepalp::station {
namespace {

constexpr const char* kAnotherPlace =
    "name a socket in a folder of your own by --control PATH, or start the station with --control none";

Error unsafe(const std::filesystem::path& folder, std::string what) {
  return {.what = std::move(what), .where = folder.string(), .fix = kAnotherPlace};
}

Error not_opened(const std::filesystem::path& folder, int code) {
  // O_NOFOLLOW with O_DIRECTORY answers ENOTDIR for a symbolic link too.
  struct stat status {};
  const bool link = ::lstat(folder.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
  if (link) return unsafe(folder, "the socket's folder is a symbolic link, which telepalp does not follow");
  return unsafe(folder, "the socket's folder cannot be opened: " + std::system_category().message(code));
}

}  // namespace

Result<OwnFolder> OwnFolder::open(const std::filesystem::path& folder, bool make) {
  if (make) (void)::mkdir(folder.c_str(), S_IRWXU);  // fails if the path exists; the checks below then decide:
  OwnFolder opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (opened.descriptor_ < 0) return not_opened(folder, errno);
  struct stat status {};
  if (::fstat(opened.descriptor_, &status) != 0) return not_opened(folder, errno);
  if (status.st_uid != ::geteuid())
    return unsafe(folder,
                  "the socket's folder belongs to another user (user id " + std::to_string(status.st_uid) + ")");
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return unsafe(folder, "other users may write to the socket's folder, and could replace the socket");
  return opened;
}

OwnFolder::OwnFolder(OwnFolder&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

OwnFolder& OwnFolder::operator=(OwnFolder&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

OwnFolder::~OwnFolder() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<OwnFolder::Entry> OwnFolder::entry(const std::string& name) const {
  struct stat status {};
  if (::fstatat(descriptor_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return std::nullopt;
  return Entry{.mode = status.st_mode, .owner = status.st_uid, .device = status.st_dev, .inode = status.st_ino};
}

void OwnFolder::remove(const std::string& name) const noexcept { (void)::unlinkat(descriptor_, name.c_str(), 0); }

void OwnFolder::lock() const noexcept { (void)::flock(descriptor_, LOCK_EX); }

void OwnFolder::unlock() const noexcept { (void)::flock(descriptor_, LOCK_UN); }

std::string OwnFolder::through_descriptor(const std::string& name) const {
  return "/proc/self/fd/" + std::to_string(descriptor_) + "/" + name;
}

}  // namespace telepalp::station
