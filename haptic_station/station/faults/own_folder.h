#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include "proto/words/result.h"

namespace telepalp::station {

/// A folder in which only this user can create, replace or remove files. It is held by a file descriptor, so that the
/// checked folder is the one that is used, even if its path is renamed meanwhile.
class OwnFolder {
 public:
  /// Opens `folder`. With `make`, a missing folder is created with access for this user only. An existing folder is
  /// never changed. Error: a symbolic link, a folder of another user, or one that others may write to (such as /tmp).
  [[nodiscard]] static Result<OwnFolder> open(const std::filesystem::path& folder, bool make);

  OwnFolder(OwnFolder&& other) noexcept;
  OwnFolder& operator=(OwnFolder&& other) noexcept;
  ~OwnFolder();

  /// File status of a directory entry; symbolic links are not followed.
  struct Entry {
    mode_t mode;
    uid_t owner;
    dev_t device;
    ino_t inode;
    [[nodiscard]] bool is(const Entry& other) const noexcept { return device == other.device && inode == other.inode; }
  };
  /// The entry of this name; nullopt: no such entry.
  [[nodiscard]] std::optional<Entry> entry(const std::string& name) const;
  void remove(const std::string& name) const noexcept;
  /// Waits until no other telepalp process has locked the folder, and locks it until unlock().
  void lock() const noexcept;
  void unlock() const noexcept;
  /// A path to `name` via the descriptor, for system calls that have no parameter for a directory's descriptor.
  [[nodiscard]] std::string through_descriptor(const std::string& name) const;

 private:
  explicit OwnFolder(int descriptor) noexcept : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace telepalp::station
