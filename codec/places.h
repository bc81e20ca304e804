#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

// Internal linkage for the same reason as in range_coder.h.

namespace telepalp::codec {
namespace {

/// Eight places of a row, in one register.
using Places [[gnu::vector_size(16)]] = uint16_t;

inline Places places_at(const uint16_t* at) {
  Places places;
  memcpy(&places, at, sizeof places);
  return places;
}

inline void put_places(uint16_t* at, Places places) { memcpy(at, &places, sizeof places); }

/// The first halves of two, in turns; and the second.
inline Places first_halves(Places a, Places b) { return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11); }
inline Places second_halves(Places a, Places b) { return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15); }

/// Four rows as one, four numbers a pixel.
inline void put_together(const uint16_t* const (&rows)[4], uint16_t* together, int width) {
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const Places a = places_at(rows[0] + x);
    const Places b = places_at(rows[1] + x);
    const Places c = places_at(rows[2] + x);
    const Places d = places_at(rows[3] + x);
    uint16_t* const to = together + 4 * x;
    put_places(to, first_halves(first_halves(a, c), first_halves(b, d)));
    put_places(to + 8, second_halves(first_halves(a, c), first_halves(b, d)));
    put_places(to + 16, first_halves(second_halves(a, c), second_halves(b, d)));
    put_places(to + 24, second_halves(second_halves(a, c), second_halves(b, d)));
  }
  for (; x < width; ++x)
    for (int i = 0; i < 4; ++i) together[4 * x + i] = rows[i][x];
}

/// The way back.
inline void take_apart(const uint16_t* together, uint16_t* const (&rows)[4], int width) {
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const uint16_t* const from = together + 4 * x;
    const Places pixels_04 = first_halves(places_at(from), places_at(from + 16));
    const Places pixels_15 = second_halves(places_at(from), places_at(from + 16));
    const Places pixels_26 = first_halves(places_at(from + 8), places_at(from + 24));
    const Places pixels_37 = second_halves(places_at(from + 8), places_at(from + 24));
    const Places even_ab = first_halves(pixels_04, pixels_26);
    const Places even_cd = second_halves(pixels_04, pixels_26);
    const Places odd_ab = first_halves(pixels_15, pixels_37);
    const Places odd_cd = second_halves(pixels_15, pixels_37);
    put_places(rows[0] + x, first_halves(even_ab, odd_ab));
    put_places(rows[1] + x, second_halves(even_ab, odd_ab));
    put_places(rows[2] + x, first_halves(even_cd, odd_cd));
    put_places(rows[3] + x, second_halves(even_cd, odd_cd));
  }
  for (; x < width; ++x)
    for (int i = 0; i < 4; ++i) rows[i][x] = together[4 * x + i];
}

}  // namespace
}  // namespace telepalp::codec
