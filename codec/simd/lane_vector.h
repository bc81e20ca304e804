#pragma once

#include <stdint.h>
#include <string.h>

#if defined(__SSE4_1__)
#include <smmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

// Internal linkage, because this header is compiled for several instruction sets (codec/entropy/range_coder.h).

namespace telepalp::codec {
namespace {

/// Four numbers in one register, one lane for each of four slices that are coded in lockstep. A comparison yields a
/// mask: all bits of a lane are set, or none.
using LaneVector [[gnu::vector_size(16)]] = int32_t;

inline LaneVector splat(int number) { return LaneVector{number, number, number, number}; }
inline LaneVector least(LaneVector a, LaneVector b) { return a < b ? a : b; }
inline LaneVector greatest(LaneVector a, LaneVector b) { return a < b ? b : a; }

/// Selects `yes` where the mask has all bits, `no` where it has none. Faster than the processor's blend instruction.
template <class Numbers>
inline Numbers pick(LaneVector mask, Numbers yes, Numbers no) {
  return no ^ ((no ^ yes) & reinterpret_cast<Numbers>(mask));
}

inline LaneVector bounded_by_two(LaneVector value) { return greatest(least(value, splat(2)), splat(-2)); }

/// The median edge detector of LOCO-I for four pixels, as predict() in codec/model/contexts.h.
inline LaneVector predict(LaneVector west, LaneVector north, LaneVector north_west) {
  return greatest(least(west + north - north_west, greatest(west, north)), least(west, north));
}

/// The four lanes as scalars. per_lane() reads them with two 64-bit moves, which is faster than four 32-bit moves.
struct PerLane {
  uint32_t of[4];
};

inline PerLane per_lane(LaneVector numbers) {
  using Halves [[gnu::vector_size(16)]] = uint64_t;
  const auto halves = reinterpret_cast<Halves>(numbers);
  const uint64_t low = halves[0];
  const uint64_t high = halves[1];
  return {{static_cast<uint32_t>(low), static_cast<uint32_t>(low >> 32), static_cast<uint32_t>(high),
           static_cast<uint32_t>(high >> 32)}};
}

inline LaneVector lanes_at(const uint16_t* at) {
#if defined(__SSE4_1__)
  return reinterpret_cast<LaneVector>(_mm_cvtepu16_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(at))));
#elif defined(__wasm_simd128__)
  return reinterpret_cast<LaneVector>(wasm_u32x4_load16x4(at));
#else
  return LaneVector{at[0], at[1], at[2], at[3]};
#endif
}

inline LaneVector wide_lanes_at(const uint32_t* at) {
  LaneVector lanes;
  memcpy(&lanes, at, sizeof lanes);
  return lanes;
}

/// Stores four numbers as 16-bit integers; each must lie in 0 … 65 535.
inline void put_lanes(uint16_t* at, LaneVector numbers) {
#if defined(__SSE4_1__)
  const auto narrow = reinterpret_cast<__m128i>(numbers);
  _mm_storel_epi64(reinterpret_cast<__m128i*>(at), _mm_packus_epi32(narrow, narrow));
#elif defined(__wasm_simd128__)
  const auto narrow = reinterpret_cast<v128_t>(numbers);
  wasm_v128_store64_lane(at, wasm_u16x8_narrow_i32x4(narrow, narrow), 0);
#else
  for (int i = 0; i < 4; ++i) at[i] = static_cast<uint16_t>(numbers[i]);
#endif
}

/// Looks up four indices in `table`, each in 0 … 15.
inline LaneVector look_up(const int8_t (&table)[16], LaneVector index) {
#if defined(__SSE4_1__)
  const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i*>(table));
  return reinterpret_cast<LaneVector>(_mm_shuffle_epi8(all, reinterpret_cast<__m128i>(index))) << 24 >> 24;
#elif defined(__wasm_simd128__)
  const v128_t all = wasm_v128_load(table);
  return reinterpret_cast<LaneVector>(wasm_i8x16_swizzle(all, reinterpret_cast<v128_t>(index))) << 24 >> 24;
#else
  return LaneVector{table[index[0]], table[index[1]], table[index[2]], table[index[3]]};
#endif
}

inline bool any(LaneVector flags) {
#if defined(__SSE4_1__)
  return _mm_movemask_epi8(reinterpret_cast<__m128i>(flags)) != 0;
#elif defined(__wasm_simd128__)
  return wasm_v128_any_true(reinterpret_cast<v128_t>(flags));
#else
  return (flags[0] | flags[1] | flags[2] | flags[3]) != 0;
#endif
}

}  // namespace
}  // namespace telepalp::codec
