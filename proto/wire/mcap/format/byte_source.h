#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Bytes that can be read anywhere: a file, or memory in a test.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual const std::string& name() const noexcept = 0;  // for errors
  [[nodiscard]] virtual std::uint64_t size() const noexcept = 0;
  /// Exactly `length` bytes from `offset`, which the caller has checked against size(); false if the medium fails.
  [[nodiscard]] virtual bool read(std::uint64_t offset, std::size_t length, std::string& into) = 0;
};

[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_file(const std::filesystem::path& file);
[[nodiscard]] std::unique_ptr<ByteSource> in_memory(std::string bytes, std::string name);

}  // namespace telepalp::wire::mcap
