#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

// Internal linkage, because this header is compiled for several instruction sets (codec/entropy/range_coder.h).

namespace telepalp::codec {
namespace {

/// Eight consecutive pixels of a row in one register.
using EightPixels [[gnu::vector_size(16)]] = uint16_t;

inline EightPixels eight_pixels_at(const uint16_t* at) {
  EightPixels places;
  memcpy(&places, at, sizeof places);
  return places;
}

inline void put_eight_pixels(uint16_t* at, EightPixels places) { memcpy(at, &places, sizeof places); }

/// Interleaves the low halves of two registers; interleave_high() interleaves the high halves.
inline EightPixels interleave_low(EightPixels a, EightPixels b) {
  return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}
inline EightPixels interleave_high(EightPixels a, EightPixels b) {
  return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}

/// Interleaves four rows into one: the four numbers of a column become adjacent.
inline void interleave_rows(const uint16_t* const (&rows)[4], uint16_t* interleaved, int width) {
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const EightPixels a = eight_pixels_at(rows[0] + x);
    const EightPixels b = eight_pixels_at(rows[1] + x);
    const EightPixels c = eight_pixels_at(rows[2] + x);
    const EightPixels d = eight_pixels_at(rows[3] + x);
    uint16_t* const to = interleaved + 4 * x;
    put_eight_pixels(to, interleave_low(interleave_low(a, c), interleave_low(b, d)));
    put_eight_pixels(to + 8, interleave_high(interleave_low(a, c), interleave_low(b, d)));
    put_eight_pixels(to + 16, interleave_low(interleave_high(a, c), interleave_high(b, d)));
    put_eight_pixels(to + 24, interleave_high(interleave_high(a, c), interleave_high(b, d)));
  }
  for (; x < width; ++x)
    for (int i = 0; i < 4; ++i) interleaved[4 * x + i] = rows[i][x];
}

/// The inverse of interleave_rows().
inline void deinterleave_rows(const uint16_t* interleaved, uint16_t* const (&rows)[4], int width) {
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const uint16_t* const from = interleaved + 4 * x;
    const EightPixels pixels_04 = interleave_low(eight_pixels_at(from), eight_pixels_at(from + 16));
    const EightPixels pixels_15 = interleave_high(eight_pixels_at(from), eight_pixels_at(from + 16));
    const EightPixels pixels_26 = interleave_low(eight_pixels_at(from + 8), eight_pixels_at(from + 24));
    const EightPixels pixels_37 = interleave_high(eight_pixels_at(from + 8), eight_pixels_at(from + 24));
    const EightPixels even_ab = interleave_low(pixels_04, pixels_26);
    const EightPixels even_cd = interleave_high(pixels_04, pixels_26);
    const EightPixels odd_ab = interleave_low(pixels_15, pixels_37);
    const EightPixels odd_cd = interleave_high(pixels_15, pixels_37);
    put_eight_pixels(rows[0] + x, interleave_low(even_ab, odd_ab));
    put_eight_pixels(rows[1] + x, interleave_high(even_ab, odd_ab));
    put_eight_pixels(rows[2] + x, interleave_low(even_cd, odd_cd));
    put_eight_pixels(rows[3] + x, interleave_high(even_cd, odd_cd));
  }
  for (; x < width; ++x)
    for (int i = 0; i < 4; ++i) rows[i][x] = interleaved[4 * x + i];
}

}  // namespace
}  // namespace telepalp::codec
