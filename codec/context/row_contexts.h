#pragma once

#include "codec/model/contexts.h"

// The part of each pixel's context that the rows above determine, computed for many pixels at once. A gap is a pixel
// that was not measured. Internal linkage, because this header is compiled for several instruction sets
// (codec/entropy/range_coder.h).

namespace telepalp::codec {
namespace {

#if defined(__AVX2__)
inline constexpr int kRowVectorPixels = 16;
#else
inline constexpr int kRowVectorPixels = 8;
#endif

/// Consecutive numbers of a row in one register. 16 bits suffice: differences are bounded and kept non-negative.
using RowVector [[gnu::vector_size(2 * kRowVectorPixels)]] = uint16_t;
using WideRowVector [[gnu::vector_size(4 * kRowVectorPixels)]] = uint32_t;

inline RowVector row_vector_at(const uint16_t* at) {
  RowVector stretch;
  memcpy(&stretch, at, sizeof stretch);
  return stretch;
}

/// The difference a - b, clamped to [-most, most] and shifted by `most`: a number from 0 to 2 * most.
inline RowVector bounded_difference(RowVector a, RowVector b, uint16_t most) {
  const RowVector higher = a > b ? a : b;
  const RowVector up = higher - b;
  const RowVector down = higher - a;
  const RowVector bound = RowVector{} + most;
  return bound + (up < bound ? up : bound) - (down < bound ? down : bound);
}

/// `value` for measured pixels, 0 for gaps.
inline RowVector flag(RowVector measured, uint16_t value) { return (RowVector{} + value) & (measured != 0); }

/// The ranks (palette indices) of the rows above: with gaps filled by predictions, and as measured.
struct RowsAbove {
  const uint16_t* filled = nullptr;
  const uint16_t* filled_two_above = nullptr;
  const uint16_t* measured = nullptr;
};

/// Computes, for `count` pixels, the part of the context that the rows above determine, with the class of the distant
/// neighbours (beyond_class() in codec/model/contexts.h). Writes up to fifteen numbers past the end. Horizontal
/// neighbours lie kStride numbers apart: 1 in a plain row, 4 in an interleaved one.
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
