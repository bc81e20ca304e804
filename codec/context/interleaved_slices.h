#pragma once

#include "codec/context/kernel_impl.h"
#include "codec/simd/lane_vector.h"
#include "codec/simd/row_interleave.h"

// Coding of four slices in lockstep, for the interleaved decoder and the near-lossless encoder. One register holds the
// neighbours, predictions or contexts of four lanes. The rows above are interleaved: the numbers of the four slices in
// one column are adjacent. A rank is the index of a depth in the frame's palette; a gap is a pixel that was not
// measured. Internal linkage, because this header is compiled for several instruction sets
// (codec/entropy/range_coder.h).

namespace telepalp::codec {
namespace {

static_assert(kLanes == 4 && kWestClass == 5);

/// Takes an interleaved row, four numbers a pixel, from scratch memory and fills it with `value`.
inline uint16_t* take_interleaved_rows(uint8_t*& scratch, int width, uint16_t value) {
  const size_t numbers = kLanes * row_bytes(width) / sizeof(uint16_t);
  auto* const rows = reinterpret_cast<uint16_t*>(scratch);
  for (size_t i = 0; i < numbers; ++i) rows[i] = value;
  scratch += numbers * sizeof(uint16_t);
  return rows + kLanes * kMargin;
}

/// The class that the reference frame gives one pixel, in each of four slices (before_class(), codec/model/contexts.h).
inline LaneVector before_classes(LaneVector before, LaneVector predicted, LaneVector west_stayed) {
  const LaneVector away = bounded_by_two(before - predicted) + 2;
  return (away + away + 1 - west_stayed) & (before != 0);
}

/// The neighbours of the current pixel in four slices. Flags are masks: all bits or none.
struct Neighbours {
  LaneVector west, west_west, north_west;
  LaneVector west_measured, west_stayed;
};

/// The input and output rows of one row of four slices; all are interleaved.
struct InterleavedRows {
  const uint16_t* above = nullptr;  ///< the row above, gaps filled with predictions
  const uint32_t* context_above = nullptr;
  const uint16_t* before = nullptr;  ///< this row of the reference frame
  uint16_t* filled = nullptr;        ///< output: ranks, gaps filled with predictions
  uint16_t* measured = nullptr;      ///< output: ranks, 0 in gaps
};

/// Prediction and context of four pixels, which select their models.
struct PixelPrediction {
  LaneVector predicted, contexts, classes;
  LaneVector was;  ///< ranks in the reference frame
};

template <bool kDependent>
inline PixelPrediction predict_pixel(const Neighbours& at, const InterleavedRows& rows, int x) {
  const LaneVector north = lanes_at(rows.above + kLanes * x);
  PixelPrediction out{};
  out.predicted = predict(at.west, north, at.north_west);
  const LaneVector from_north = bounded_by_two(at.west - at.north_west);
  const LaneVector five_from_north =
      (from_north << 2) + from_north;  // a shift and an add: shorter than a multiplication on the critical path
  out.contexts = wide_lanes_at(rows.context_above + kLanes * x) + (2 + 2 * kWestClass) +
                 (at.west_measured & kWestMeasured) + bounded_by_two(at.west_west - at.west) + five_from_north;
  if constexpr (kDependent) {
    out.was = lanes_at(rows.before + kLanes * x);
    out.classes = before_classes(out.was, out.predicted, at.west_stayed);
  }
  return out;
}

/// Stores four pixels and moves the neighbours one pixel to the east.
inline void step_east(Neighbours& at, const InterleavedRows& rows, int x, LaneVector value, LaneVector is_measured,
                      LaneVector was) {
  const LaneVector rank = value & is_measured;
  put_lanes(rows.filled + kLanes * x, value);
  put_lanes(rows.measured + kLanes * x, rank);
  at = {value, at.west, lanes_at(rows.above + kLanes * x), is_measured, rank == was};
}

/// The neighbours of a row's first pixel: its northern neighbour replaces those to the west, which do not exist.
inline Neighbours neighbours_at_start(const InterleavedRows& rows) {
  const LaneVector start = lanes_at(rows.above);
  return {start, start, start, LaneVector{}, LaneVector{}};
}

/// The interleaved rows that the coding of four slices keeps: the current row and the rows above it.
struct InterleavedHistory {
  uint16_t* above = nullptr;  // ranks of the row above, gaps filled with predictions
  uint16_t* two_above = nullptr;
  uint16_t* measured_above = nullptr;
  uint16_t* filled = nullptr;
  uint16_t* measured = nullptr;
  uint16_t* before = nullptr;
  uint32_t* contexts = nullptr;
};

inline InterleavedHistory take_history(uint8_t*& scratch, int width) {
  InterleavedHistory taken;
  taken.above = take_interleaved_rows(scratch, width, 1);
  taken.two_above = take_interleaved_rows(scratch, width, 1);
  taken.measured_above = take_interleaved_rows(scratch, width, 0);
  taken.filled = take_interleaved_rows(scratch, width, 0);
  taken.measured = take_interleaved_rows(scratch, width, 0);
  taken.before = take_interleaved_rows(scratch, width, 0);
  taken.contexts = reinterpret_cast<uint32_t*>(take_interleaved_rows(scratch, 2 * width + 2 * kMargin, 0));
  return taken;
}

/// Prepares the next row. `before`: the same rows of the reference frame; nullptr: key frame.
inline InterleavedRows begin_rows(const InterleavedHistory& history, const uint16_t* const (*before)[kLanes],
                                  int width) {
  classify_above<kLanes>({history.above, history.two_above, history.measured_above}, history.contexts, kLanes * width);
  if (before != nullptr) interleave_rows(*before, history.before, width);
  return {history.above, history.contexts, history.before, history.filled, history.measured};
}

/// Finishes a row: repeats its first and last pixel as padding, and makes it the row above.
inline void end_rows(InterleavedHistory& history, int width) {
  uint16_t* const filled = history.filled;
  for (int i = 0; i < kLanes; ++i) {
    filled[i - kLanes] = filled[i - 2 * kLanes] = filled[i];
    filled[kLanes * width + i] = filled[kLanes * (width + 1) + i] = filled[kLanes * (width - 1) + i];
  }
  swap_rows(history.two_above, history.above);
  swap_rows(history.above, history.filled);
  swap_rows(history.measured_above, history.measured);
}

}  // namespace
}  // namespace telepalp::codec
