#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Renames atomically unless `to` exists. Returns 0, or -1 with errno set. On file systems without RENAME_NOREPLACE, an
/// existing `to` is replaced.
[[nodiscard]] int rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to);

/// A file that gets its name only when it is complete: it grows as `NAME.partial` and is renamed at the end. create()
/// fails if either name exists, so no existing file is overwritten. While it grows it is locked with flock, so that
/// other programs can distinguish a file being written from one whose writer has died.
class OutputFile {
 public:
  [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& name);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();  // closes; an unpublished file stays as NAME.partial

  [[nodiscard]] Result<void> append(std::string_view bytes);
  /// Truncates to `size` after a partial append.
  void cut(std::uint64_t size) noexcept;
  /// Calls fsync and renames the file to its final name.
  [[nodiscard]] Result<void> publish();
  /// Closes and removes the file.
  void discard() noexcept;

  [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return name_; }
  [[nodiscard]] std::filesystem::path partial_name() const;

 private:
  OutputFile(std::filesystem::path name, int descriptor) noexcept : name_(std::move(name)), descriptor_(descriptor) {}
  [[nodiscard]] Error failure(int code, const std::string& consequence) const;

  std::filesystem::path name_;
  int descriptor_;
};

}  // namespace telepalp::wire::mcap
