#pragma once

#include "codec/context/interleaved_slices.h"

// Decodes four slices of equal height in lockstep, one per lane of a SIMD register. Predictions and contexts are
// computed for four lanes at once; only the symbols are decoded lane by lane. All functions have internal linkage, so
// that the linker keeps one copy for each instruction set.

namespace telepalp::codec {
namespace {

template <class Vector>
struct InterleavedDecoder {
  RangeDecoder coders[kLanes];
  Model* models[kLanes];
  Model far_models[kLanes] = {kFlatModel, kFlatModel, kFlatModel, kFlatModel};

  [[gnu::noinline]] LaneVector with_far_steps(LaneVector steps, LaneVector symbols) {
    for (int i = 0; i < kLanes; ++i)
      if (symbols[i] == kFarther) steps[i] = decode_far(coders[i], far_models[i]);
    return steps;
  }

  template <int kRate>
  int symbol_of(int lane, uint32_t model) {
    Model& at = models[lane][model];
    const int symbol = Vector::decode(coders[lane], at);
    Vector::template learn<kRate>(at, symbol);
    return symbol;
  }

  template <bool kDependent, int kRate>
  LaneVector symbols_of(LaneVector contexts, LaneVector classes, const uint8_t* group_of) {
    const PerLane context = per_lane(contexts);
    const PerLane of_before = per_lane(classes);
    const auto symbol = [&](int lane) {
      const uint32_t group = group_of[context.of[lane]];
      return symbol_of<kRate>(lane, kDependent ? group * kBeforeClasses + of_before.of[lane] : group);
    };
    const int first = symbol(0);
    const int second = symbol(1);
    const int third = symbol(2);
    const int fourth = symbol(3);
    return LaneVector{first, second, third, fourth};
  }

  template <bool kDependent, int kRate>
  void decode_row(const InterleavedRows& rows, int width, const uint8_t* group_of) {
    Neighbours at = neighbours_at_start(rows);
    for (int x = 0; x < width; ++x) {
      const PixelPrediction out = predict_pixel<kDependent>(at, rows, x);
      const LaneVector symbols = symbols_of<kDependent, kRate>(out.contexts, out.classes, group_of);
      LaneVector steps = look_up(kStepOf, symbols);
      if (any(symbols == int{kFarther})) [[unlikely]]
        steps = with_far_steps(steps, symbols);
      step_east(at, rows, x, (out.predicted + steps) & 0xffff, symbols != int{kNotMeasured}, out.was);
    }
  }
};

template <class Vector, bool kDependent>
void decode_interleaved_slices(DecodeSlice* slices, int width, const ContextTables& tables, void* scratch) {
  InterleavedDecoder<Vector> decoder;
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < kLanes; ++i) {
    decoder.models[i] = take_models(room, tables);
    decoder.coders[i].start(slices[i].bytes, slices[i].size);
  }
  InterleavedHistory history = take_history(room, width);
  for (int row = 0; row < slices[0].rows; ++row) {
    const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
    const uint16_t* before[kLanes];
    uint16_t* ranks[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      before[i] = kDependent ? slices[i].before + first : nullptr;
      ranks[i] = slices[i].ranks + first;
    }
    const InterleavedRows rows = begin_rows(history, kDependent ? &before : nullptr, width);
    if (learning_rate(kDependent, row) == kSettledRate)
      decoder.template decode_row<kDependent, kSettledRate>(rows, width, tables.group_of);
    else
      decoder.template decode_row<kDependent, kLearningRate>(rows, width, tables.group_of);
    deinterleave_rows(rows.measured, ranks, width);
    end_rows(history, width);
  }
}

/// Decodes `count` slices: four slices of equal height in SIMD lanes, any others with the scalar decode().
template <class Vector>
void decode_interleaved(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  if (count < kLanes || slices[kLanes - 1].rows != slices[0].rows)
    return decode<Vector>(slices, count, width, tables, scratch);
  const auto code =
      slices[0].before != nullptr ? decode_interleaved_slices<Vector, true> : decode_interleaved_slices<Vector, false>;
  code(slices, width, tables, scratch);
}

}  // namespace
}  // namespace telepalp::codec
