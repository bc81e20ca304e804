#pragma once

#include "codec/depth_contexts.h"

// What a row's contexts owe to the rows above, many places at once. Internal linkage for the same reason as in
// range_coder.h.

namespace telepalp::codec {
namespace {

#if defined(__AVX2__)
inline constexpr int kPlacesAtOnce = 16;
#else
inline constexpr int kPlacesAtOnce = 8;
#endif

/// Neighbouring places of a row, in one register. 16 bits do, as differences are bounded without ever being negative.
using Stretch [[gnu::vector_size(2 * kPlacesAtOnce)]] = uint16_t;
using WideStretch [[gnu::vector_size(4 * kPlacesAtOnce)]] = uint32_t;

inline Stretch stretch_at(const uint16_t* at) {
  Stretch stretch;
  memcpy(&stretch, at, sizeof stretch);
  return stretch;
}

/// bounded(a - b, most) + most.
inline Stretch bounded_difference(Stretch a, Stretch b, uint16_t most) {
  const Stretch higher = a > b ? a : b;
  const Stretch up = higher - b;
  const Stretch down = higher - a;
  const Stretch bound = Stretch{} + most;
  return bound + (up < bound ? up : bound) - (down < bound ? down : bound);
}

/// `value` where something was measured.
inline Stretch flag(Stretch measured, uint16_t value) { return (Stretch{} + value) & (measured != 0); }

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
  for (int i = 0; i < count; i += kPlacesAtOnce) {
    const uint16_t* const at = rows.filled + i;
    const Stretch north = stretch_at(at);
    const Stretch west = stretch_at(at - kStride);
    const Stretch east = stretch_at(at + kStride);
    const Stretch classes = 25 * bounded_difference(east, north, 2) + kNorthClass * bounded_difference(north, west, 2);
    const uint16_t* const measured = rows.measured + i;
    const Stretch flags = flag(stretch_at(measured), kNorthMeasured) +
                          flag(stretch_at(measured - kStride), 2 * kNorthMeasured) +
                          flag(stretch_at(measured + kStride), 4 * kNorthMeasured);
    const Stretch beyond = bounded_difference(stretch_at(rows.filled_two_above + i), north, 1) +
                           3 * bounded_difference(stretch_at(at + 2 * kStride), east, 1) +
                           9 * bounded_difference(stretch_at(at - 2 * kStride), west, 1);
    const auto contexts = kContexts * __builtin_convertvector(beyond, WideStretch) +
                          __builtin_convertvector(classes + flags, WideStretch);
    memcpy(context + i, &contexts, sizeof contexts);
  }
}

}  // namespace
}  // namespace telepalp::codec
