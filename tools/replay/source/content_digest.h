#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace telepalp::replay {

/// A digest by which equal contents are recognised: FNV-1a over words of eight bytes. It does not protect from forgery.
class ContentDigest {
 public:
  void add(std::span<const std::byte> bytes) noexcept;
  void add(const std::string& text) noexcept { add(std::as_bytes(std::span(text))); }
  [[nodiscard]] std::string hex() const;

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// The digest of the files that `source` names: a recording, or all files of a folder. Empty: `source` names no file,
/// as a synthetic patient, or its files cannot be read.
[[nodiscard]] std::string digest_of_source(const std::string& source);

}  // namespace telepalp::replay
