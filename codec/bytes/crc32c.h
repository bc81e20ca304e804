#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace telepalp::codec {

/// CRC-32C (Castagnoli, reflected, as in iSCSI) of `bytes`, carried on from `before`, the CRC of what lies in front.
/// The processor's instruction is used where it has one; the answer is the same.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before = 0) noexcept;

/// The same, always by tables: the oracle for the fast path, and the path where there is none.
[[nodiscard]] std::uint32_t crc32c_by_table(std::span<const std::byte> bytes, std::uint32_t before = 0) noexcept;

}  // namespace telepalp::codec
