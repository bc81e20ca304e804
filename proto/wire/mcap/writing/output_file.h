#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// 0, or -1 with the reason in errno: an existing `to` is refused. Where a file system cannot refuse, it is replaced.
[[nodiscard]] int rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to);

/// A file that appears under its name only when it is complete: it grows as `NAME.partial` and is renamed at the
/// end. Neither name may exist before; nothing of anyone's is ever overwritten. While it grows it is locked (flock), so
/// that others can tell a file that is being written from one whose writer died.
class OutputFile {
 public:
  [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& name);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();  // closes; what was not published stays as NAME.partial

  [[nodiscard]] Result<void> append(std::string_view bytes);
  /// Cuts back to `size` after an append that failed half-way.
  void cut(std::uint64_t size) noexcept;
  /// Puts it on the disk and gives it its name.
  [[nodiscard]] Result<void> publish();
  /// Closes and removes it.
  void discard() noexcept;

  [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return name_; }
  [[nodiscard]] std::filesystem::path partial_name() const;

 private:
  OutputFile(std::filesystem::path name, int descriptor) noexcept : name_(std::move(name)), descriptor_(descriptor) {}
  [[nodiscard]] Error failure(int code) const;

  std::filesystem::path name_;
  int descriptor_;
};

}  // namespace telepalp::wire::mcap
