#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include "proto/words/result.h"

namespace telepalp::station {

/// A folder in which nobody but this user can make, replace or remove a file. It is held by a descriptor: what is
/// looked at is what is used, even if somebody renames the path meanwhile.
class OwnFolder {
 public:
  /// Opens `folder`; with `make`, a missing one is made, for this user alone. A folder that exists is never changed: an
  /// error if it is a symbolic link, another user's, or writable by others (as /tmp is).
  [[nodiscard]] static Result<OwnFolder> open(const std::filesystem::path& folder, bool make);

  OwnFolder(OwnFolder&& other) noexcept;
  OwnFolder& operator=(OwnFolder&& other) noexcept;
  ~OwnFolder();

  /// What stands at a name in the folder; a symbolic link is not followed.
  struct Entry {
    mode_t mode;
    uid_t owner;
    dev_t device;
    ino_t inode;
    [[nodiscard]] bool is(const Entry& other) const noexcept { return device == other.device && inode == other.inode; }
  };
  /// nullopt: nothing stands there.
  [[nodiscard]] std::optional<Entry> entry(const std::string& name) const;
  void remove(const std::string& name) const noexcept;
  /// Between lock() and unlock(), no other process of telepalp is between its own two.
  void lock() const noexcept;
  void unlock() const noexcept;
  /// A path to `name` through the descriptor, for system calls that take no descriptor of a folder.
  [[nodiscard]] std::string through_descriptor(const std::string& name) const;

 private:
  explicit OwnFolder(int descriptor) noexcept : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace telepalp::station
