#pragma once

#include <cstddef>
#include <span>

namespace telepalp::models {

/// Upper bound of the decompressed size of `compressed` bytes: a back reference of 3 bytes expands to at most 264.
[[nodiscard]] constexpr std::size_t lzf_most(std::size_t compressed) noexcept { return compressed * 88 + 264; }

/// Decompresses LZF, the format of PCD's binary_compressed. True when the decompressed bytes fill `out` exactly.
[[nodiscard]] bool lzf_decompress(std::span<const std::byte> compressed, std::span<std::byte> out) noexcept;

}  // namespace telepalp::models
