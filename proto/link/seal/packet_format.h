#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "proto/words/little_endian.h"

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

inline void write_header(const SealHeader& header, HeaderBytes out) noexcept {
  out[0] = std::byte{kSealVersion};
  out[1] = std::byte{0};
  put_little_endian<std::uint16_t>(&out[2], header.epoch);
  put_little_endian<std::uint32_t>(&out[4], header.session);
  put_little_endian<std::uint64_t>(&out[8], header.sequence);
}

/// The header of `datagram`; nullopt: the datagram's size, version or reserved byte is wrong.
[[nodiscard]] inline std::optional<SealHeader> read_header(std::span<const std::byte> datagram) noexcept {
  if (datagram.size() < kHeaderBytes + kTagBytes || datagram.size() > kDatagramBytes) return std::nullopt;
  if (datagram[0] != std::byte{kSealVersion} || datagram[1] != std::byte{0}) return std::nullopt;
  return SealHeader{.epoch = get_little_endian<std::uint16_t>(&datagram[2]),
                    .session = get_little_endian<std::uint32_t>(&datagram[4]),
                    .sequence = get_little_endian<std::uint64_t>(&datagram[8])};
}

}  // namespace telepalp::link
