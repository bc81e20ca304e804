#pragma once

#include "codec/context/interleaved_encoders.h"
#include "codec/context/slice_state.h"
#include "proto/words/vectorised.h"

// The coder's inner loop. The parameter `Vector` supplies the symbol search and model update of an instruction set.
// Internal linkage, because this header is compiled for several instruction sets (codec/entropy/range_coder.h).

namespace telepalp::codec {
namespace {

/// Symbol search and model update with the baseline instructions of the architecture.
struct Plain {
  static int decode(RangeDecoder& coder, const Model& model) { return coder.decode(model); }
  template <int kRate>
  static void learn(Model& model, int symbol) {
    codec::learn<kRate>(model, symbol);
  }
};

/// Contexts, predictions and symbols of a whole row, which the encoder computes before it codes the row.
struct RowPlan {
  uint32_t* context = nullptr;
  uint16_t* predicted = nullptr;
  uint16_t* symbol = nullptr;
  uint16_t* before_class = nullptr;  // before_class() of codec/model/contexts.h; unused in key frames
};

template <bool kDependent, class Coder>
inline Model& model_for(Lane<Coder>& lane, int x, int predicted, const ContextTables& tables) {
  const uint32_t context = lane.context_above[x] + static_cast<uint32_t>(context_from_row(
                                                       lane.west, lane.west_west, lane.north_west, lane.west_measured));
  const int group = tables.group_of[context];
  if constexpr (kDependent)
    return lane.models[group * kBeforeClasses + before_class(lane.before[x], predicted, lane.west_stayed)];
  return lane.models[group];
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

[[gnu::noinline]] int decode_far(RangeDecoder& coder, Model& model) {
  const int size = static_cast<int>(decode_number(coder, model)) + kLargestStep + 1;
  return coder.decode_bits(1) != 0 ? -size : size;
}

/// Bit i is set if the i-th of 16 numbers is zero.
inline uint32_t zeros_of(const uint16_t* at) {
#if defined(__SSE2__)
  const __m128i zero = _mm_setzero_si128();
  const __m128i low = _mm_cmpeq_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)), zero);
  const __m128i high = _mm_cmpeq_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at + 8)), zero);
  return static_cast<uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
#else
  uint32_t zeros = 0;
  for (uint32_t i = 0; i < 16; ++i) zeros |= (at[i] == 0 ? 1U : 0U) << i;
  return zeros;
#endif
}

/// Copies the row and fills its gaps (pixels that were not measured) with predictions, from west to east.
inline void fill_gaps(Lane<RangeEncoder>& lane, const uint16_t* ranks, int width) {
  uint16_t* const filled = lane.filled;
  const uint16_t* const above = lane.filled_above;
  memcpy(lane.measured, ranks, static_cast<size_t>(width) * sizeof(uint16_t));
  memcpy(filled, ranks, static_cast<size_t>(width) * sizeof(uint16_t));
  filled[-1] = filled[-2] = above[0];  // begin_row() starts the decoder's rows with the same values
  for (int from = 0; from < width; from += 16) {
    uint32_t gaps = zeros_of(lane.measured + from);
    if (width - from < 16) gaps &= (1U << (width - from)) - 1;
    const bool is_flat = filled[from - 1] == above[from - 1] && memcmp(above + from - 1, above + from, 32) == 0;
    if (gaps == 0xffff && is_flat) {  // common in empty frames: all predictions are equal to the row above
      for (int x = from; x < from + 16; ++x) filled[x] = above[x];
      continue;
    }
    for (; gaps != 0; gaps &= gaps - 1) {
      const int x = from + __builtin_ctz(gaps);
      filled[x] = static_cast<uint16_t>(predict(filled[x - 1], above[x], above[x - 1]));
    }
  }
}

/// Computes the plan of a row. No iteration of the loop uses the result of another, so the compiler vectorises it.
template <bool kDependent>
inline void plan_row(const Lane<RangeEncoder>& lane, const RowPlan& plan, int width) {
  const uint16_t* const filled = lane.filled;
  const uint16_t* const above = lane.filled_above;
  const uint16_t* const measured = lane.measured;
  const uint32_t* const context_above = lane.context_above;
  uint32_t* const __restrict context = plan.context;
  uint16_t* const __restrict predicted = plan.predicted;
  uint16_t* const __restrict symbol = plan.symbol;
  TELEPALP_INDEPENDENT_TURNS
  for (int x = 0; x < width; ++x) {
    const int west = filled[x - 1];
    const int north_west = above[x - 1];
    const int expected = predict(west, above[x], north_west);
    const int step = bounded(static_cast<int>(filled[x]) - expected, 7);
    const int zigzag = step > 0 ? 2 * step : (step < 0 ? 1 - 2 * step : 0);
    predicted[x] = static_cast<uint16_t>(expected);
    symbol[x] = static_cast<uint16_t>(measured[x] == 0 ? int{kNotMeasured} : (zigzag < kFarther ? zigzag : kFarther));
    context[x] = context_above[x] + static_cast<uint32_t>((bounded(filled[x - 2] - west, 2) + 2) +
                                                          kWestClass * (bounded(west - north_west, 2) + 2) +
                                                          (measured[x - 1] != 0 ? kWestMeasured : 0));
  }
  if constexpr (!kDependent) return;
  uint16_t* const __restrict before_classes = plan.before_class;
  const uint16_t* const before = lane.before;
  before_classes[0] = static_cast<uint16_t>(before_class(before[0], predicted[0], false));
  for (int x = 1; x < width; ++x)
    before_classes[x] = static_cast<uint16_t>(before_class(before[x], predicted[x], measured[x - 1] == before[x - 1]));
}

template <class Vector, bool kDependent, int kRate>
inline void encode_pixel(Lane<RangeEncoder>& lane, const RowPlan& plan, int x, const ContextTables& tables) {
  int index = tables.group_of[plan.context[x]];
  if constexpr (kDependent) index = index * kBeforeClasses + plan.before_class[x];
  Model& model = lane.models[index];
  const int symbol = plan.symbol[x];
  lane.coder.encode(model, symbol);
  Vector::template learn<kRate>(model, symbol);
  if (symbol == kFarther) [[unlikely]]
    encode_far(lane.coder, lane.far_model, static_cast<int>(lane.filled[x]) - plan.predicted[x]);
}

template <class Vector, bool kDependent, int kRate>
inline void decode_pixel(Lane<RangeDecoder>& lane, int x, const ContextTables& tables) {
  const int predicted = predict(lane.west, lane.filled_above[x], lane.north_west);
  Model& model = model_for<kDependent>(lane, x, predicted, tables);
  const int symbol = Vector::decode(lane.coder, model);
  Vector::template learn<kRate>(model, symbol);
  int step = kStepOf[symbol];
  if (symbol == kFarther) [[unlikely]]
    step = decode_far(lane.coder, lane.far_model);
  step_east<kDependent>(lane, x, predicted + step, symbol != kNotMeasured);
}

template <class Vector, bool kDependent, int kRate, int kCount>
void encode_row(Lane<RangeEncoder>* lanes, const RowPlan* plans, int width, const ContextTables& tables) {
  for (int x = 0; x < width; ++x)
#pragma GCC unroll 4
    for (int i = 0; i < kCount; ++i) encode_pixel<Vector, kDependent, kRate>(lanes[i], plans[i], x, tables);
}

template <class Vector, bool kDependent, int kRate, int kCount>
void decode_row(Lane<RangeDecoder>* lanes, int width, const ContextTables& tables) {
  for (int x = 0; x < width; ++x)
#pragma GCC unroll 4
    for (int i = 0; i < kCount; ++i) decode_pixel<Vector, kDependent, kRate>(lanes[i], x, tables);
}

template <class Vector, bool kDependent, int kRate>
void encode_rows(Lane<RangeEncoder>* lanes, const RowPlan* plans, int count, int width, const ContextTables& tables) {
  if (count == kLanes) return encode_row<Vector, kDependent, kRate, kLanes>(lanes, plans, width, tables);
  for (int i = 0; i < count; ++i) encode_row<Vector, kDependent, kRate, 1>(lanes + i, plans + i, width, tables);
}

template <class Vector, bool kDependent, int kRate>
void decode_rows(Lane<RangeDecoder>* lanes, int count, int width, const ContextTables& tables) {
  if (count == kLanes) return decode_row<Vector, kDependent, kRate, kLanes>(lanes, width, tables);
  for (int i = 0; i < count; ++i) decode_row<Vector, kDependent, kRate, 1>(lanes + i, width, tables);
}

template <class Vector, bool kDependent>
void encode_slices(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  Lane<RangeEncoder> lanes[kLanes];
  RowPlan plans[kLanes];
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < count; ++i) {
    start(lanes[i], room, width, tables);
    plans[i] = {take_wide_row(room, width), take_row(room, width), take_row(room, width), take_row(room, width)};
    lanes[i].coder.start(slices[i].bytes, slices[i].room);
  }
  for (int row = 0; row < slices[0].rows; ++row) {
    const int active = row < slices[count - 1].rows ? count : count - 1;
    const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
    for (int i = 0; i < active; ++i) {
      begin_row(lanes[i], width);
      if constexpr (kDependent) lanes[i].before = slices[i].before + first;
      fill_gaps(lanes[i], slices[i].ranks + first, width);
      plan_row<kDependent>(lanes[i], plans[i], width);
    }
    if (learning_rate(kDependent, row) == kSettledRate)
      encode_rows<Vector, kDependent, kSettledRate>(lanes, plans, active, width, tables);
    else
      encode_rows<Vector, kDependent, kLearningRate>(lanes, plans, active, width, tables);
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
    if (learning_rate(kDependent, row) == kSettledRate)
      decode_rows<Vector, kDependent, kSettledRate>(lanes, active, width, tables);
    else
      decode_rows<Vector, kDependent, kLearningRate>(lanes, active, width, tables);
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
