#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Storage that grows and gets its name when it is complete: a file, or a session in a cluster. Owner: one thread.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  /// Writes at `offset`, which is at most the size, so that nothing is skipped. Error: `bytes` may be stored in part.
  [[nodiscard]] virtual Result<void> write(std::uint64_t offset, std::string_view bytes) = 0;
  /// Removes all bytes from `size` on.
  virtual void cut(std::uint64_t size) noexcept = 0;
  /// Stores all bytes for good, under the final name. No other function may be called after it.
  [[nodiscard]] virtual Result<void> publish() = 0;
  /// Removes the bytes.
  virtual void discard() noexcept = 0;
};

/// A file `NAME.partial`, which publish() renames to `name`. While it grows it is locked with flock, so that other
/// programs can distinguish a file being written from one whose writer has died. Error: either name exists.
[[nodiscard]] Result<std::unique_ptr<ByteSink>> new_file(const std::filesystem::path& name);

}  // namespace telepalp::wire::mcap
