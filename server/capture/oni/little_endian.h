#pragma once

#include <bit>
#include <cstring>
#include <string_view>

namespace telepalp::capture {

static_assert(std::endian::native == std::endian::little, "an .oni file is little-endian; its bytes are not swapped");

/// The little-endian number at offset `at` [B]. All bytes of the number must lie within `bytes`.
template <class Number>
[[nodiscard]] Number little_endian(std::string_view bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

}  // namespace telepalp::capture
