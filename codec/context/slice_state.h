#pragma once

#include "codec/context/kernel.h"
#include "codec/context/row_contexts.h"

// One slice's state in the coder's inner loop: the range coder, the models and the rows above. A rank is the index of a
// depth in the frame's palette; a gap is a pixel that was not measured. Internal linkage, because this header is
// compiled for several instruction sets (codec/entropy/range_coder.h).

namespace telepalp::codec {
namespace {

/// Padding before and after each row, so that neighbours can be read without a bounds check.
constexpr int kMargin = 16;

constexpr size_t row_bytes(int width) {
  return (static_cast<size_t>(width) + size_t{2} * kMargin + 15) / 16 * 16 * sizeof(uint16_t);
}

/// Bytes of scratch memory that hold the rows and models of any kernel.
constexpr size_t scratch_of_kernels(int width, const ContextTables& tables) {
  return kLanes * (static_cast<size_t>(tables.count) * sizeof(Model) + 15 * row_bytes(width));
}

/// The state of one slice between pixels.
template <class Coder>
struct Lane {
  Coder coder;
  Model* models = nullptr;
  Model far_model = kFlatModel;
  uint16_t* filled = nullptr;        // ranks of this row, gaps filled with predictions
  uint16_t* filled_above = nullptr;  // the row above, gaps filled with predictions
  uint16_t* filled_two_above = nullptr;
  uint16_t* measured_above = nullptr;  // ranks of the row above: 0 is a gap
  uint16_t* measured = nullptr;
  uint32_t* context_above = nullptr;  // the part of each pixel's context that the rows above determine
  int west = 0;
  int west_west = 0;
  int north_west = 0;
  bool west_measured = false;
  const uint16_t* before = nullptr;  // this row of the reference frame
  bool west_stayed = false;
};

inline uint16_t* take_row(uint8_t*& scratch, int width) {
  auto* const row = reinterpret_cast<uint16_t*>(scratch) + kMargin;
  scratch += row_bytes(width);
  return row;
}

inline uint32_t* take_wide_row(uint8_t*& scratch, int width) {
  auto* const row = reinterpret_cast<uint32_t*>(scratch) + kMargin;
  scratch += 2 * row_bytes(width);
  return row;
}

/// Copies the trained models into scratch memory: their state at the start of a slice.
inline Model* take_models(uint8_t*& scratch, const ContextTables& tables) {
  auto* const models = reinterpret_cast<Model*>(scratch);
  const size_t bytes = static_cast<size_t>(tables.count) * sizeof(Model);
  memcpy(models, tables.models, bytes);
  scratch += bytes;
  return models;
}

template <class Coder>
void start(Lane<Coder>& lane, uint8_t*& scratch, int width, const ContextTables& tables) {
  lane.models = take_models(scratch, tables);
  uint16_t** const rows[] = {&lane.filled, &lane.filled_above, &lane.filled_two_above, &lane.measured,
                             &lane.measured_above};
  for (uint16_t** row : rows) {
    memset(scratch, 0, row_bytes(width));
    *row = take_row(scratch, width);
  }
  lane.context_above = take_wide_row(scratch, width);
  for (int x = -kMargin; x < width + kMargin; ++x) lane.filled_above[x] = lane.filled_two_above[x] = 1;
}

/// Prepares a row: the part of its contexts that the rows above determine, and the neighbours of the first pixel.
template <class Coder>
void begin_row(Lane<Coder>& lane, int width) {
  classify_above<1>({lane.filled_above, lane.filled_two_above, lane.measured_above}, lane.context_above, width);
  lane.west = lane.west_west = lane.north_west = lane.filled_above[0];
  lane.west_measured = false;
  lane.west_stayed = false;
}

template <class Number>
inline void swap_rows(Number*& a, Number*& b) {
  Number* const was = a;
  a = b;
  b = was;
}

template <class Coder>
void end_row(Lane<Coder>& lane, int width) {
  lane.filled[-1] = lane.filled[-2] = lane.filled[0];
  lane.filled[width] = lane.filled[width + 1] = lane.filled[width - 1];
  swap_rows(lane.filled_two_above, lane.filled_above);
  swap_rows(lane.filled_above, lane.filled);
  swap_rows(lane.measured_above, lane.measured);
}

}  // namespace
}  // namespace telepalp::codec
