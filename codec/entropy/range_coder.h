#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

// All functions have internal linkage and call nothing of the C++ library. Several source files compile this header for
// different instruction sets, and the linker must never use one file's code in another.

namespace telepalp::codec {

/// Symbols of a model: 0 … 14.
inline constexpr int kSymbols = 15;
inline constexpr uint32_t kModelTotal = 32767;

/// Cumulative frequencies of 15 symbols: the probability of symbol s is (cdf[s + 1] - cdf[s]) / 32 767. cdf[0] = 0 and
/// cdf[15] = 32 767.
struct alignas(32) Model {
  uint16_t cdf[16];
};

namespace {

/// The targets that a model's cumulative frequencies move towards when symbol s is coded: row s. Each symbol keeps a
/// frequency of at least 1 of 32 767, because neighbouring targets differ by at least 1 and rounding is downwards.
struct alignas(32) ModelTargets {
  int16_t of[16][16];
};

constexpr ModelTargets make_targets() {
  ModelTargets targets{};
  for (int symbol = 0; symbol < 16; ++symbol)
    for (int place = 0; place < 16; ++place)
      targets.of[symbol][place] =
          static_cast<int16_t>(place <= symbol ? place : static_cast<int>(kModelTotal) - 15 + place);
  return targets;
}

constexpr ModelTargets kTargets = make_targets();

constexpr Model kFlatModel = [] {
  Model model{};
  for (int place = 0; place < 16; ++place)
    model.cdf[place] = static_cast<uint16_t>(static_cast<uint32_t>(place) * kModelTotal / kSymbols);
  return model;
}();

/// Half a model, in one 128-bit SIMD register.
using HalfModel [[gnu::vector_size(16), gnu::may_alias]] = int16_t;

/// Moves the model by 2^-kRate of the distance to the symbol's targets. No loop is used, because not every compiler
/// vectorises loops.
template <int kRate>
inline void learn(Model& model, int symbol) {
  auto* const at = reinterpret_cast<HalfModel*>(model.cdf);
  const auto* const target = reinterpret_cast<const HalfModel*>(kTargets.of[symbol]);
  const HalfModel low = at[0];
  const HalfModel high = at[1];
  at[0] = low + ((target[0] - low) >> kRate);
  at[1] = high + ((target[1] - high) >> kRate);
}

/// The symbol whose range contains a cumulative frequency.
inline int symbol_at(const Model& model, uint32_t frequency) {
#if defined(__SSE2__)
  const auto* const at = reinterpret_cast<const __m128i*>(model.cdf);
  const __m128i bound = _mm_set1_epi16(static_cast<int16_t>(frequency));
  const __m128i above =
      _mm_packs_epi16(_mm_cmpgt_epi16(_mm_load_si128(at), bound), _mm_cmpgt_epi16(_mm_load_si128(at + 1), bound));
  return __builtin_ctz(static_cast<uint32_t>(_mm_movemask_epi8(above)) | 0x8000U) - 1;
#elif defined(__wasm_simd128__)
  const v128_t bound = wasm_i16x8_splat(static_cast<int16_t>(frequency));
  const v128_t above = wasm_i8x16_narrow_i16x8(wasm_i16x8_gt(wasm_v128_load(model.cdf), bound),
                                               wasm_i16x8_gt(wasm_v128_load(model.cdf + 8), bound));
  return __builtin_ctz(wasm_i8x16_bitmask(above) | 0x8000U) - 1;
#else
  int symbol = 0;
  for (int place = 1; place < kSymbols; ++place) symbol += model.cdf[place] <= frequency ? 1 : 0;
  return symbol;
#endif
}

/// `range` * `frequency` / 32 768, rounded down: where a cumulative frequency lies in a 16-bit range.
inline uint32_t part(uint32_t range, uint32_t frequency) { return (range * 2 * frequency) >> 16; }

inline int leading_zeros16(uint32_t value) { return __builtin_clz(value) - 16; }

/// Range encoder (Martin 1979) with a 16-bit range, as in Daala, so that the products of a whole model fit one AVX2
/// register. One forward pass, no division.
struct RangeEncoder {
  uint64_t low = 0;  // from the low end: 16 bits of the current range, `pending` output bits, one carry bit
  uint32_t range = 0xffff;
  int pending = 0;
  uint8_t* begin = nullptr;
  uint8_t* at = nullptr;
  uint8_t* limit = nullptr;
  bool overflowed = false;

  void start(uint8_t* bytes, size_t room) {
    begin = at = bytes;
    limit = bytes + room;
  }

  void encode(const Model& model, int symbol) {
    encode_part(part(range, model.cdf[symbol]), part(range, model.cdf[symbol + 1]));
  }

  /// Codes `count` equiprobable bits, at most 8.
  void encode_bits(uint32_t value, int count) { encode_part((range * value) >> count, (range * (value + 1)) >> count); }

  /// Flushes and returns the number of bytes written; 0: the buffer was too small. The decoder reads zero bits after
  /// the end.
  size_t finish() {
    uint64_t rest =
        (low + 0x7fff) >> 15;  // any number within the range is valid: take the one with most trailing zeros
    const int bits = pending + 1;
    if ((rest >> bits) != 0) carry();
    rest <<= 64 - bits;
    if (overflowed || limit - at < 8) return 0;
    for (int left = bits; left > 0; left -= 8, rest <<= 8) *at++ = static_cast<uint8_t>(rest >> 56);
    return static_cast<size_t>(at - begin);
  }

  void encode_part(uint32_t from, uint32_t to) {
    range = to - from;
    const int shift = leading_zeros16(range);
    range <<= shift;
    low = (low + from) << shift;
    pending += shift;
    if (pending >= 32) [[unlikely]]
      put_word();
  }

  void put_word() {
    pending -= 32;
    const uint64_t word = low >> (16 + pending);
    low &= (uint64_t{1} << (16 + pending)) - 1;
    if ((word >> 32) != 0) carry();
    if (limit - at < 8) {
      overflowed = true;
      at = begin;
    }
    for (int byte = 0; byte < 4; ++byte) *at++ = static_cast<uint8_t>(word >> (24 - 8 * byte));
  }

  void carry() {
    for (uint8_t* byte = at; byte != begin && ++*--byte == 0;) {
    }
  }
};

/// Decodes what RangeEncoder wrote. A damaged stream yields arbitrary symbols, but never reads past the end.
struct RangeDecoder {
  uint64_t window = 0;  // from the high end: 16 bits of the code, then `spare` bits read ahead
  uint32_t range = 0xffff;
  int spare = 0;
  const uint8_t* at = nullptr;
  const uint8_t* end = nullptr;

  void start(const uint8_t* bytes, size_t size) {
    at = bytes;
    end = bytes + size;
    window = uint64_t{next_word()} << 32;
    spare = 16;
  }

  [[nodiscard]] uint32_t code() const { return static_cast<uint32_t>(window >> 48); }

  [[nodiscard]] int decode(const Model& model) {
    const uint32_t frequency =
        (((code() + 1) << 15) - 1) / range;  // the largest frequency that scales to at most the code
    const int symbol = symbol_at(model, frequency < kModelTotal ? frequency : kModelTotal - 1);
    took(part(range, model.cdf[symbol]), part(range, model.cdf[symbol + 1]));
    return symbol;
  }

  [[nodiscard]] uint32_t decode_bits(int count) {
    const uint32_t most = (uint32_t{1} << count) - 1;
    uint32_t value = (((code() + 1) << count) - 1) / range;
    if (value > most) value = most;
    took((range * value) >> count, (range * (value + 1)) >> count);
    return value;
  }

  void took(uint32_t from, uint32_t to) {
    window -= uint64_t{from} << 48;
    range = to - from;
    const int shift = leading_zeros16(range);
    range <<= shift;
    window <<= shift;
    spare -= shift;
    if (spare < 16) [[unlikely]] {
      window |= uint64_t{next_word()} << (16 - spare);
      spare += 32;
    }
  }

  [[nodiscard]] uint32_t next_word() {
    if (end - at >= 4) [[likely]] {
      uint32_t word = 0;
      memcpy(&word, at, 4);
      at += 4;
      return __builtin_bswap32(word);
    }
    return last_word();
  }

  /// Returns zeros past the end.
  [[gnu::noinline, nodiscard]] uint32_t last_word() {
    uint32_t word = 0;
    for (int byte = 0; byte < 4; ++byte) word = word << 8 | (at != end ? *at++ : 0U);
    return word;
  }
};

/// The largest number that encode_number() can encode: value + 1 is at most 2^14 + 2^16 - 1, because 16 lower bits
/// follow the greatest of the 15 length symbols.
constexpr uint32_t kLargestNumber = 81'918;
static_assert(kLargestNumber + 1 == (1U << (kSymbols - 1)) + 0xffffU);

/// Encodes a number of at most kLargestNumber: one symbol for the bit length of value + 1, then its lower bits.
inline void encode_number(RangeEncoder& coder, Model& length_model, uint32_t value) {
  if (value > kLargestNumber) __builtin_trap();  // not demand(), the usual check: it needs the C++ library
  int length = 0;
  while (((value + 1) >> (length + 1)) != 0 && length < kSymbols - 1) ++length;
  coder.encode(length_model, length);
  learn<4>(length_model, length);
  const uint32_t below = value + 1 - (uint32_t{1} << length);
  const int bits = length == kSymbols - 1 ? 16 : length;  // 16 lower bits follow the greatest length symbol
  if (bits > 8) coder.encode_bits(below >> 8, bits - 8);
  coder.encode_bits(below & (bits > 8 ? 0xffU : (uint32_t{1} << bits) - 1), bits > 8 ? 8 : bits);
}

[[nodiscard]] inline uint32_t decode_number(RangeDecoder& coder, Model& length_model) {
  const int length = coder.decode(length_model);
  learn<4>(length_model, length);
  const int bits = length == kSymbols - 1 ? 16 : length;
  uint32_t below = bits > 8 ? coder.decode_bits(bits - 8) << 8 : 0;
  below |= coder.decode_bits(bits > 8 ? 8 : bits);
  return below + (uint32_t{1} << length) - 1;
}

}  // namespace
}  // namespace telepalp::codec
