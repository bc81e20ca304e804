#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "proto/words/little_endian.h"

namespace telepalp::codec {

/// Appends a little-endian number.
template <class T>
void append(std::string& bytes, T value) {
  append_little_endian<T>(bytes, value);
}

/// Appends a number of up to 32 bits, seven bits a byte, the lowest first; the top bit of a byte is set if another byte
/// follows.
inline void append_varint(std::string& bytes, std::uint32_t value) {
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<char>(0x80 | (value & 0x7f)));
  bytes.push_back(static_cast<char>(value));
}

/// Reads numbers off the front of a packet; nullopt when it ends too soon. Never reads past the end.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  template <class T>
  [[nodiscard]] std::optional<T> number() noexcept {
    if (bytes_.size() < sizeof(T)) return std::nullopt;
    const auto value = get_little_endian<T>(bytes_.data());
    bytes_ = bytes_.subspan(sizeof value);
    return value;
  }

  [[nodiscard]] std::optional<std::uint32_t> varint() noexcept {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 5 && i < bytes_.size(); ++i) {
      const auto byte = std::to_integer<std::uint32_t>(bytes_[i]);
      if (i == 4 && byte > 0x0f) return std::nullopt;
      value |= (byte & 0x7f) << (7 * i);
      if (byte < 0x80) {
        bytes_ = bytes_.subspan(i + 1);
        return value;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::span<const std::byte>> take(std::size_t size) noexcept {
    if (bytes_.size() < size) return std::nullopt;
    const std::span<const std::byte> taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }

  [[nodiscard]] std::span<const std::byte> rest() const noexcept { return bytes_; }
  [[nodiscard]] bool empty() const noexcept { return bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace telepalp::codec
