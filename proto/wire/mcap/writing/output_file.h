#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "proto/wire/mcap/sealed/sealer.h"
#include "proto/wire/mcap/format/byte_sink.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Renames atomically unless `to` exists. Returns 0, or -1 with errno set. On file systems without RENAME_NOREPLACE, an
/// existing `to` is replaced.
[[nodiscard]] int rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to);

/// Whether a session file is encrypted: if TELEPALP_SITE_KEYS names a key, or never, such as a copy that is given away.
enum class Protection { OfSite, None };

/// A session file that gets its name only when it is complete, so no existing file is overwritten. Where a place for
/// its name was added (add_place()), it is stored there, else on the disk.
class OutputFile {
 public:
  [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& name, Protection protection);

  /// Appends all of `bytes`. Error: nothing is appended.
  [[nodiscard]] Result<void> append(std::string_view bytes);
  /// Stores the file for good, under its final name.
  [[nodiscard]] Result<void> publish();
  /// Closes and removes the file.
  void discard() noexcept;
  /// Closes the file, which stays as NAME.partial.
  void leave() noexcept { sink_.reset(); }

  [[nodiscard]] bool is_open() const noexcept { return sink_ != nullptr; }
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return name_; }

 private:
  OutputFile(std::filesystem::path name, std::unique_ptr<ByteSink> sink) noexcept
      : name_(std::move(name)), sink_(std::move(sink)) {}

  std::filesystem::path name_;
  std::unique_ptr<ByteSink> sink_;  // null: closed
  std::optional<Sealer> sealer_;    // nullopt: the file is not encrypted
  std::uint64_t size_ = 0;          // of an unencrypted file
};

}  // namespace telepalp::wire::mcap
