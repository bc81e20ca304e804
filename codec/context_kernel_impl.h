#pragma once

#include "codec/context_kernel.h"

// The coder's inner loop, once for each instruction set: `Vector` finds and learns symbols its own way. Internal
// linkage for the same reason as in range_coder.h.

namespace telepalp::codec {
namespace {

/// Places in front of and behind a row, so that neighbours can be read without asking.
constexpr int kMargin = 16;

constexpr size_t row_bytes(int width) {
  return (static_cast<size_t>(width) + size_t{2} * kMargin + 15) / 16 * 16 * sizeof(uint16_t);
}

/// What one slice carries from pixel to pixel.
template <class Coder>
struct Lane {
  Coder coder;
  Model* models = nullptr;
  Model far_model = kFlatModel;
  uint16_t* filled = nullptr;          // this row, gaps filled with predictions
  uint16_t* filled_above = nullptr;    //
  uint16_t* measured_above = nullptr;  // ranks of the row above: 0 is a gap
  uint16_t* measured = nullptr;
  uint16_t* context_above = nullptr;  // share of each pixel's context that the row above decides
  int west = 0;
  int west_west = 0;
  int north_west = 0;
  bool west_measured = false;
  const uint16_t* before = nullptr;  // this row in the frame before
  bool west_stayed = false;
};

template <class Coder>
void start(Lane<Coder>& lane, uint8_t*& scratch, int width, const ContextTables& tables) {
  lane.models = reinterpret_cast<Model*>(scratch);
  const size_t model_bytes = static_cast<size_t>(tables.count) * sizeof(Model);
  memcpy(lane.models, tables.models, model_bytes);
  scratch += model_bytes;
  uint16_t** const rows[] = {&lane.filled, &lane.filled_above, &lane.measured, &lane.measured_above,
                             &lane.context_above};
  for (uint16_t** row : rows) {
    memset(scratch, 0, row_bytes(width));
    *row = reinterpret_cast<uint16_t*>(scratch) + kMargin;
    scratch += row_bytes(width);
  }
  for (int x = -kMargin; x < width + kMargin; ++x) lane.filled_above[x] = 1;
}

/// Before a row: what the one above says, and the neighbours of its first pixel.
template <class Coder>
void begin_row(Lane<Coder>& lane, int width) {
  const uint16_t* const filled = lane.filled_above;
  const uint16_t* const measured = lane.measured_above;
  for (int x = 0; x < width; ++x)
    lane.context_above[x] = static_cast<uint16_t>(context_from_above(filled + x, measured + x));
  lane.west = lane.west_west = lane.north_west = lane.filled_above[0];
  lane.west_measured = false;
  lane.west_stayed = false;
}

template <class Coder>
void end_row(Lane<Coder>& lane, int width) {
  lane.filled[-1] = lane.filled[0];
  lane.filled[width] = lane.filled[width - 1];
  uint16_t* const filled = lane.filled;
  lane.filled = lane.filled_above;
  lane.filled_above = filled;
  uint16_t* const measured = lane.measured;
  lane.measured = lane.measured_above;
  lane.measured_above = measured;
}

template <bool kDependent, class Coder>
inline Model& model_for(Lane<Coder>& lane, int x, int predicted, const ContextTables& tables) {
  const int context =
      lane.context_above[x] + context_from_row(lane.west, lane.west_west, lane.north_west, lane.west_measured);
  const int cluster = tables.cluster_of[context];
  if constexpr (kDependent)
    return lane.models[cluster * kBeforeClasses + before_class(lane.before[x], predicted, lane.west_stayed)];
  return lane.models[cluster];
}

template <bool kDependent, class Coder>
inline void step_east(Lane<Coder>& lane, int x, int filled, bool is_measured) {
  lane.filled[x] = static_cast<uint16_t>(filled);
  lane.measured[x] = static_cast<uint16_t>(is_measured ? filled : 0);
  lane.west_west = lane.west;
  lane.west = static_cast<uint16_t>(filled);
  lane.north_west = lane.filled_above[x];
  lane.west_measured = is_measured;
  if constexpr (kDependent) lane.west_stayed = lane.measured[x] == lane.before[x];
}

[[gnu::noinline]] void encode_far(Lane<RangeEncoder>& lane, int step) {
  const int size = step < 0 ? -step : step;
  encode_number(lane.coder, lane.far_model, static_cast<uint32_t>(size - kLargestStep - 1));
  lane.coder.encode_bits(step < 0 ? 1 : 0, 1);
}

[[gnu::noinline]] int decode_far(Lane<RangeDecoder>& lane) {
  const int size = static_cast<int>(decode_number(lane.coder, lane.far_model)) + kLargestStep + 1;
  return lane.coder.decode_bits(1) != 0 ? -size : size;
}

template <class Vector, bool kDependent>
inline void encode_pixel(Lane<RangeEncoder>& lane, int x, int rank, const ContextTables& tables) {
  const int predicted = predict(lane.west, lane.filled_above[x], lane.north_west);
  Model& model = model_for<kDependent>(lane, x, predicted, tables);
  const int step = rank - predicted;
  const int symbol = rank == 0 ? int{kNotMeasured} : int{kSymbolOf[bounded(step, 7) + 7]};
  lane.coder.encode(model, symbol);
  Vector::learn(model, symbol);
  if (symbol == kFarther) [[unlikely]]
    encode_far(lane, step);
  step_east<kDependent>(lane, x, rank == 0 ? predicted : rank, rank != 0);
}

template <class Vector, bool kDependent>
inline void decode_pixel(Lane<RangeDecoder>& lane, int x, const ContextTables& tables) {
  const int predicted = predict(lane.west, lane.filled_above[x], lane.north_west);
  Model& model = model_for<kDependent>(lane, x, predicted, tables);
  const int symbol = Vector::decode(lane.coder, model);
  Vector::learn(model, symbol);
  int step = kStepOf[symbol];
  if (symbol == kFarther) [[unlikely]]
    step = decode_far(lane);
  step_east<kDependent>(lane, x, predicted + step, symbol != kNotMeasured);
}

template <class Vector, bool kDependent, int kCount>
void encode_row(Lane<RangeEncoder>* lanes, const EncodeSlice* slices, int row, int width, const ContextTables& tables) {
  const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
  for (int x = 0; x < width; ++x)
#pragma GCC unroll 4
    for (int i = 0; i < kCount; ++i)
      encode_pixel<Vector, kDependent>(lanes[i], x, slices[i].ranks[first + static_cast<size_t>(x)], tables);
}

template <class Vector, bool kDependent, int kCount>
void decode_row(Lane<RangeDecoder>* lanes, int width, const ContextTables& tables) {
  for (int x = 0; x < width; ++x)
#pragma GCC unroll 4
    for (int i = 0; i < kCount; ++i) decode_pixel<Vector, kDependent>(lanes[i], x, tables);
}

template <class Vector, bool kDependent>
void encode_slices(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  Lane<RangeEncoder> lanes[kLanes];
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < count; ++i) {
    start(lanes[i], room, width, tables);
    lanes[i].coder.start(slices[i].bytes, slices[i].room);
  }
  for (int row = 0; row < slices[0].rows; ++row) {
    const int active = row < slices[count - 1].rows ? count : count - 1;
    const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
    for (int i = 0; i < active; ++i) {
      begin_row(lanes[i], width);
      if constexpr (kDependent) lanes[i].before = slices[i].before + first;
    }
    if (active == kLanes) {
      encode_row<Vector, kDependent, kLanes>(lanes, slices, row, width, tables);
    } else {
      for (int i = 0; i < active; ++i) encode_row<Vector, kDependent, 1>(lanes + i, slices + i, row, width, tables);
    }
    for (int i = 0; i < active; ++i) end_row(lanes[i], width);
  }
  for (int i = 0; i < count; ++i) slices[i].size = lanes[i].coder.finish();
}

template <class Vector, bool kDependent>
void decode_slices(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  Lane<RangeDecoder> lanes[kLanes];
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < count; ++i) {
    start(lanes[i], room, width, tables);
    lanes[i].coder.start(slices[i].bytes, slices[i].size);
  }
  for (int row = 0; row < slices[0].rows; ++row) {
    const int active = row < slices[count - 1].rows ? count : count - 1;
    const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
    for (int i = 0; i < active; ++i) {
      begin_row(lanes[i], width);
      if constexpr (kDependent) lanes[i].before = slices[i].before + first;
    }
    if (active == kLanes) {
      decode_row<Vector, kDependent, kLanes>(lanes, width, tables);
    } else {
      for (int i = 0; i < active; ++i) decode_row<Vector, kDependent, 1>(lanes + i, width, tables);
    }
    for (int i = 0; i < active; ++i) {
      memcpy(slices[i].ranks + first, lanes[i].measured, static_cast<size_t>(width) * sizeof(uint16_t));
      end_row(lanes[i], width);
    }
  }
}

template <class Vector>
void encode(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  const auto code = slices[0].before != nullptr ? encode_slices<Vector, true> : encode_slices<Vector, false>;
  code(slices, count, width, tables, scratch);
}

template <class Vector>
void decode(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  const auto code = slices[0].before != nullptr ? decode_slices<Vector, true> : decode_slices<Vector, false>;
  code(slices, count, width, tables, scratch);
}

}  // namespace
}  // namespace telepalp::codec
