#include "codec/bytes/crc32c.h"

#include <array>
#include <cstring>

#if defined(__x86_64__)
#include <nmmintrin.h>
#endif

namespace telepalp::codec {
namespace {

constexpr std::uint32_t kReflectedPolynomial = 0x82f63b78;
constexpr std::size_t kStride = 8;  // bytes processed at once, with one table each

using Tables = std::array<std::array<std::uint32_t, 256>, kStride>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? kReflectedPolynomial : 0);
    tables[0][byte] = crc;
  }
  for (std::size_t table = 1; table < kStride; ++table)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t shorter = tables[table - 1][byte];
      tables[table][byte] = (shorter >> 8) ^ tables[0][shorter & 0xff];
    }
  return tables;
}

constexpr Tables kTables = make_tables();

#if defined(__x86_64__)
constexpr std::size_t kStretch = 2048;  // bytes in each of three sums before they are combined

/// Tables of the effect of kStretch zero bytes on a sum, one table for each byte of the sum.
std::array<std::array<std::uint32_t, 256>, 4> make_stretch_tables() {
  std::array<std::array<std::uint32_t, 256>, 4> tables{};
  for (std::size_t place = 0; place < tables.size(); ++place)
    for (std::uint32_t bit = 1; bit < 256; bit *= 2) {
      std::uint32_t crc = bit << (8 * place);
      for (std::size_t byte = 0; byte < kStretch; ++byte) crc = (crc >> 8) ^ kTables[0][crc & 0xff];
      for (std::uint32_t below = 0; below < bit; ++below) tables[place][bit + below] = tables[place][below] ^ crc;
    }
  return tables;
}

std::uint32_t past_a_stretch(std::uint32_t crc) noexcept {
  static const auto tables = make_stretch_tables();
  return tables[0][crc & 0xff] ^ tables[1][(crc >> 8) & 0xff] ^ tables[2][(crc >> 16) & 0xff] ^ tables[3][crc >> 24];
}

std::uint64_t word_at(const std::byte* at) noexcept {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return word;
}

/// Computes three stretches in parallel: the instruction takes three cycles, and one can start in each cycle.
__attribute__((target("sse4.2"))) std::uint32_t crc32c_by_instruction(std::span<const std::byte> bytes,
                                                                      std::uint32_t before) noexcept {
  std::uint64_t crc = ~before;
  for (; bytes.size() >= 3 * kStretch; bytes = bytes.subspan(3 * kStretch)) {
    std::uint64_t second = 0;
    std::uint64_t third = 0;
    for (std::size_t i = 0; i < kStretch; i += 8) {
      crc = _mm_crc32_u64(crc, word_at(&bytes[i]));
      second = _mm_crc32_u64(second, word_at(&bytes[kStretch + i]));
      third = _mm_crc32_u64(third, word_at(&bytes[2 * kStretch + i]));
    }
    const std::uint32_t first_two =
        past_a_stretch(static_cast<std::uint32_t>(crc)) ^ static_cast<std::uint32_t>(second);
    crc = past_a_stretch(first_two) ^ static_cast<std::uint32_t>(third);
  }
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) crc = _mm_crc32_u64(crc, word_at(bytes.data()));
  auto narrow = static_cast<std::uint32_t>(crc);
  for (const std::byte byte : bytes) narrow = _mm_crc32_u8(narrow, std::to_integer<unsigned char>(byte));
  return ~narrow;
}
#endif

}  // namespace

std::uint32_t crc32c_by_table(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
  std::uint32_t crc = ~before;
  for (; bytes.size() >= kStride; bytes = bytes.subspan(kStride)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof word);
    word ^= crc;
    crc = 0;
    for (std::size_t i = 0; i < kStride; ++i) crc ^= kTables[kStride - 1 - i][(word >> (8 * i)) & 0xff];
  }
  for (const std::byte byte : bytes) crc = (crc >> 8) ^ kTables[0][(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xff];
  return ~crc;
}

std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
#if defined(__x86_64__)
  static const bool has_instruction = __builtin_cpu_supports("sse4.2") != 0;
  if (has_instruction) return crc32c_by_instruction(bytes, before);
#endif
  return crc32c_by_table(bytes, before);
}

}  // namespace telepalp::codec
