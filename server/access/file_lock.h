#pragma once

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::access {

/// The lock of a file that one program alone may write. It ends with this object, and with the program.
class FileLock {
 public:
  /// The lock of no file.
  FileLock() = default;
  /// Takes the lock of `file`, without waiting. A missing file is created empty, for its owner alone. Where the file
  /// system has no locks, it counts as taken. Error: another program has it.
  [[nodiscard]] static Result<FileLock> take(const std::filesystem::path& file);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  /// False if `file` is now the name of another file, or of none.
  [[nodiscard]] bool is_of(const std::filesystem::path& file) const;

 private:
  explicit FileLock(int descriptor) noexcept : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

}  // namespace telepalp::access
