#pragma once

#include "codec/model/contexts.h"

// What a row's contexts owe to the rows above, many places at once. Internal linkage for the same reason as in
// range_coder.h.

namespace telepalp::codec {
namespace {

#if defined(__AVX2__)
inline constexpr int kRowVectorPixels = 16;
#else
inline constexpr int kRowVectorPixels = 8;
#endif

/// Neighbouring places of a row, in one register. 16 bits do, as differences are bounded without ever being negative.
using RowVector [[gnu::vector_size(2 * kRowVectorPixels)]] = uint16_t;
using WideRowVector [[gnu::vector_size(4 * kRowVectorPixels)]] = uint32_t;

inline RowVector row_vector_at(const uint16_t* at) {
  RowVector stretch;
  memcpy(&stretch, at, sizeof stretch);
  return stretch;
}

/// bounded(a - b, most) + most.
inline RowVector bounded_difference(RowVector a, RowVector b, uint16_t most) {
  const RowVector higher = a > b ? a : b;
  const RowVector up = higher - b;
  const RowVector down = higher - a;
  const RowVector bound = RowVector{} + most;
  return bound + (up < bound ? up : bound) - (down < bound ? down : bound);
}

/// `value` where something was measured.
inline RowVector flag(RowVector measured, uint16_t value) { return (RowVector{} + value) & (measured != 0); }

/// Rows above, filled and as measured; neighbours lie `kStride` numbers apart.
struct RowsAbove {
  const uint16_t* filled = nullptr;
  const uint16_t* filled_two_above = nullptr;
  const uint16_t* measured = nullptr;
};

/// What the rows above decide of each context, beyond_class() and all, of `count` numbers and up to fifteen behind
/// them.
template <int kStride>
inline void classify_above(const RowsAbove& rows, uint32_t* context, int count) {
  for (int i = 0; i < count; i += kRowVectorPixels) {
    const uint16_t* const at = rows.filled + i;
    const RowVector north = row_vector_at(at);
    const RowVector west = row_vector_at(at - kStride);
    const RowVector east = row_vector_at(at + kStride);
    const RowVector classes =
        25 * bounded_difference(east, north, 2) + kNorthClass * bounded_difference(north, west, 2);
    const uint16_t* const measured = rows.measured + i;
    const RowVector flags = flag(row_vector_at(measured), kNorthMeasured) +
                            flag(row_vector_at(measured - kStride), 2 * kNorthMeasured) +
                            flag(row_vector_at(measured + kStride), 4 * kNorthMeasured);
    const RowVector beyond = bounded_difference(row_vector_at(rows.filled_two_above + i), north, 1) +
                             3 * bounded_difference(row_vector_at(at + 2 * kStride), east, 1) +
                             9 * bounded_difference(row_vector_at(at - 2 * kStride), west, 1);
    const auto contexts = kContexts * __builtin_convertvector(beyond, WideRowVector) +
                          __builtin_convertvector(classes + flags, WideRowVector);
    memcpy(context + i, &contexts, sizeof contexts);
  }
}

}  // namespace
}  // namespace telepalp::codec
