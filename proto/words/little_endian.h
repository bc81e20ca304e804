#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

namespace telepalp {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied byte for byte into packets and files: the machine must be little-endian");

/// Writes the sizeof(Number) bytes of a number, the lowest first, at `at`.
template <class Number, class Byte>
void put_little_endian(Byte* at, std::type_identity_t<Number> value) noexcept {
  static_assert(std::is_arithmetic_v<Number> && sizeof(Byte) == 1);
  std::memcpy(at, &value, sizeof value);
}

/// Appends a number to `bytes`, its lowest byte first.
template <class Number>
void append_little_endian(std::string& bytes, std::type_identity_t<Number> value) {
  bytes.resize(bytes.size() + sizeof value);
  put_little_endian<Number>(bytes.data() + bytes.size() - sizeof value, value);
}

/// The number whose sizeof(Number) bytes, the lowest first, begin at `at`. All of them must be readable.
template <class Number, class Byte>
[[nodiscard]] Number get_little_endian(const Byte* at) noexcept {
  static_assert(std::is_arithmetic_v<Number> && sizeof(Byte) == 1);
  Number value{};
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace telepalp
