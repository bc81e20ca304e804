#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace telepalp::codec {

/// CRC-32C (Castagnoli, reflected, as in iSCSI) of `bytes`, continued from `before`, the CRC of the preceding bytes. It
/// uses the processor's CRC instruction if there is one; the result is the same.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before = 0) noexcept;

/// CRC-32C computed with tables: the reference for tests of the fast path, and used on processors without the
/// instruction.
[[nodiscard]] std::uint32_t crc32c_by_table(std::span<const std::byte> bytes, std::uint32_t before = 0) noexcept;

}  // namespace telepalp::codec
