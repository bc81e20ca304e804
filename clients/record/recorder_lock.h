#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::record {

/// The lock that a recorder holds on its file while it writes: whoever holds it may change or delete the file.
class RecorderLock {
 public:
  /// Takes the lock of `file`, without waiting. `failed`: the beginning of the error, such as "cannot be deleted".
  /// Error: a recorder writes the file, or has meanwhile completed it under its final name; or it cannot be opened.
  [[nodiscard]] static Result<RecorderLock> take(const std::filesystem::path& file, const std::string& failed);
  RecorderLock(RecorderLock&& other) noexcept;
  RecorderLock& operator=(RecorderLock&&) = delete;
  ~RecorderLock();

 private:
  explicit RecorderLock(int descriptor) noexcept : descriptor_(descriptor) {}
  [[nodiscard]] bool is_of(const std::filesystem::path& file) const;

  int descriptor_;
};

}  // namespace telepalp::record
