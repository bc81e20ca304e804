#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/little_endian.h"

namespace telepalp::wire::mcap {

/// Appends MCAP's little-endian primitives to a string.
class ByteAppender {
 public:
  explicit ByteAppender(std::string& out) noexcept : out_(out) {}

  void u8(std::uint8_t value) { out_.push_back(static_cast<char>(value)); }
  void u16(std::uint16_t value) { append_little_endian<std::uint16_t>(out_, value); }
  void u32(std::uint32_t value) { append_little_endian<std::uint32_t>(out_, value); }
  void u64(std::uint64_t value) { append_little_endian<std::uint64_t>(out_, value); }
  void raw(std::string_view bytes) { out_.append(bytes); }
  /// A string or byte array with its 32-bit length in front.
  void text(std::string_view bytes) {
    u32(static_cast<std::uint32_t>(bytes.size()));
    raw(bytes);
  }

 private:
  std::string& out_;
};

/// Reads MCAP's primitives from untrusted bytes. After a read past the end, ok() is false and further reads return zero
/// or an empty view, so that a parser needs only one check, at its end.
class ByteCursor {
 public:
  explicit ByteCursor(std::string_view bytes) noexcept : rest_(bytes) {}

  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

  std::uint8_t u8() noexcept { return whole<std::uint8_t>(); }
  std::uint16_t u16() noexcept { return whole<std::uint16_t>(); }
  std::uint32_t u32() noexcept { return whole<std::uint32_t>(); }
  std::uint64_t u64() noexcept { return whole<std::uint64_t>(); }
  /// Reads `length` bytes and returns them as a view into the input.
  std::string_view raw(std::uint64_t length) noexcept {
    if (!ok_ || length > rest_.size()) {
      fail();
      return {};
    }
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }
  /// A string or byte array with its 32-bit length in front.
  std::string_view text() noexcept { return raw(u32()); }

 private:
  template <class T>
  T whole() noexcept {
    const std::string_view bytes = raw(sizeof(T));
    return bytes.empty() ? T{} : get_little_endian<T>(bytes.data());
  }
  void fail() noexcept {
    ok_ = false;
    rest_ = {};
  }
  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace telepalp::wire::mcap
