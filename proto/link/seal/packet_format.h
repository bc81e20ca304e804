#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace telepalp::link {

/// Sizes of a sealed datagram: header, ciphertext, tag. Every IPv6 path carries a datagram of 1200 B without
/// fragmentation (RFC 9000 §14).
inline constexpr std::size_t kDatagramBytes = 1200;
inline constexpr std::size_t kHeaderBytes = 16;
inline constexpr std::size_t kTagBytes = 16;
inline constexpr std::size_t kPayloadBytes = kDatagramBytes - kHeaderBytes - kTagBytes;

inline constexpr std::uint8_t kSealVersion = 1;

/// The header of a sealed datagram, authenticated and not encrypted. All numbers are little-endian.
struct SealHeader {
  std::uint16_t epoch = 0;     ///< number of the sender's key, from 0
  std::uint32_t session = 0;   ///< random number by which the server names the session, and thereby its keys
  std::uint64_t sequence = 0;  ///< counts each sender's datagrams, across epochs
};

using HeaderBytes = std::span<std::byte, kHeaderBytes>;

inline void put_little_endian(std::byte* at, std::uint64_t value, std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; ++i) at[i] = static_cast<std::byte>(value >> (8 * i));
}
[[nodiscard]] inline std::uint64_t get_little_endian(const std::byte* at, std::size_t bytes) noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value |= std::to_integer<std::uint64_t>(at[i]) << (8 * i);
  return value;
}

inline void write_header(const SealHeader& header, HeaderBytes out) noexcept {
  out[0] = std::byte{kSealVersion};
  out[1] = std::byte{0};
  put_little_endian(&out[2], header.epoch, 2);
  put_little_endian(&out[4], header.session, 4);
  put_little_endian(&out[8], header.sequence, 8);
}

/// The header of `datagram`; nullopt: the datagram's size, version or reserved byte is wrong.
[[nodiscard]] inline std::optional<SealHeader> read_header(std::span<const std::byte> datagram) noexcept {
  if (datagram.size() < kHeaderBytes + kTagBytes || datagram.size() > kDatagramBytes) return std::nullopt;
  if (datagram[0] != std::byte{kSealVersion} || datagram[1] != std::byte{0}) return std::nullopt;
  return SealHeader{.epoch = static_cast<std::uint16_t>(get_little_endian(&datagram[2], 2)),
                    .session = static_cast<std::uint32_t>(get_little_endian(&datagram[4], 4)),
                    .sequence = get_little_endian(&datagram[8], 8)};
}

}  // namespace telepalp::link
