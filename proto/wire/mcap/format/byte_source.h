#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Random access to bytes: a file, or memory in a test.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual const std::string& name() const noexcept = 0;  // for error messages
  [[nodiscard]] virtual std::uint64_t size() const noexcept = 0;
  /// Reads exactly `length` bytes at `offset`; the caller has checked both against size(). False on an I/O error.
  [[nodiscard]] virtual bool read(std::uint64_t offset, std::size_t length, std::string& into) = 0;
  /// The first offset at or after `offset` that is not in a hole of a sparse file; size() if there is none.
  [[nodiscard]] virtual std::uint64_t next_data(std::uint64_t offset) const noexcept { return offset; }
};

/// The bytes of a session, decrypted if they are encrypted, from the disk or the place that was added for its name
/// (add_place()). Error: it cannot be opened, or its key is not given.
[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_session(const std::filesystem::path& file);
/// The bytes of a file on the disk, as they are.
[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_file(const std::filesystem::path& file);
[[nodiscard]] std::unique_ptr<ByteSource> in_memory(std::string bytes, std::string name);

}  // namespace telepalp::wire::mcap
