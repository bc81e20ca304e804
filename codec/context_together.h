#pragma once

#include "codec/context_kernel_impl.h"
#include "codec/four.h"
#include "codec/places.h"

// Decoding four slices of equal height at once: their neighbours, predictions and contexts lie in one register each,
// and only the symbols are found one by one. Internal linkage for the same reason as in range_coder.h.

namespace telepalp::codec {
namespace {

static_assert(kLanes == 4 && kWestClass == 5);

/// Rows of all four slices in one: four numbers a pixel.
inline uint16_t* take_rows_together(uint8_t*& scratch, int width, uint16_t value) {
  const size_t numbers = kLanes * row_bytes(width) / sizeof(uint16_t);
  auto* const rows = reinterpret_cast<uint16_t*>(scratch);
  for (size_t i = 0; i < numbers; ++i) rows[i] = value;
  scratch += numbers * sizeof(uint16_t);
  return rows + kLanes * kMargin;
}

/// before_class() of four slices.
inline Four before_classes(Four before, Four predicted, Four west_stayed) {
  const Four away = bounded_by_two(before - predicted) + 2;
  return (away + away + 1 - west_stayed) & (before != 0);
}

/// What four slices carry from pixel to pixel. Flags are all bits or none.
struct Neighbours {
  Four west, west_west, north_west;
  Four west_measured, west_stayed;
};

/// One row of each slice, four numbers a pixel.
struct RowsTogether {
  const uint16_t* above = nullptr;  ///< filled
  const uint32_t* context_above = nullptr;
  const uint16_t* before = nullptr;  ///< in the frame before
  uint16_t* filled = nullptr;        ///< written, as is:
  uint16_t* measured = nullptr;
};

template <class Vector>
struct Together {
  RangeDecoder coders[kLanes];
  Model* models[kLanes];
  Model far_models[kLanes] = {kFlatModel, kFlatModel, kFlatModel, kFlatModel};

  [[gnu::noinline]] Four with_far_steps(Four steps, Four symbols) {
    for (int i = 0; i < kLanes; ++i)
      if (symbols[i] == kFarther) steps[i] = decode_far(coders[i], far_models[i]);
    return steps;
  }

  template <int kRate>
  int symbol_of(int lane, int model) {
    Model& at = models[lane][model];
    const int symbol = Vector::decode(coders[lane], at);
    Vector::template learn<kRate>(at, symbol);
    return symbol;
  }

  template <bool kDependent, int kRate>
  Four symbols_of(Four contexts, Four classes, const uint8_t* group_of) {
    const auto model = [&](int context, int of_before) {
      const int group = group_of[context];
      return kDependent ? group * kBeforeClasses + of_before : group;
    };
    const int first = symbol_of<kRate>(0, model(contexts[0], classes[0]));
    const int second = symbol_of<kRate>(1, model(contexts[1], classes[1]));
    const int third = symbol_of<kRate>(2, model(contexts[2], classes[2]));
    const int fourth = symbol_of<kRate>(3, model(contexts[3], classes[3]));
    return Four{first, second, third, fourth};
  }

  template <bool kDependent, int kRate>
  void decode_row(const RowsTogether& rows, int width, const uint8_t* group_of) {
    const Four start = four_at(rows.above);
    Neighbours at{start, start, start, Four{}, Four{}};
    for (int x = 0; x < width; ++x) {
      const Four north = four_at(rows.above + kLanes * x);
      const Four predicted = predict(at.west, north, at.north_west);
      const Four from_north = bounded_by_two(at.west - at.north_west);
      const Four five_from_north = (from_north << 2) + from_north;  // shorter than to multiply, and all wait for it
      const Four contexts = wide_four_at(rows.context_above + kLanes * x) + (2 + 2 * kWestClass) +
                            (at.west_measured & kWestMeasured) + bounded_by_two(at.west_west - at.west) +
                            five_from_north;
      const Four was = kDependent ? four_at(rows.before + kLanes * x) : Four{};
      const Four classes = kDependent ? before_classes(was, predicted, at.west_stayed) : Four{};
      const Four symbols = symbols_of<kDependent, kRate>(contexts, classes, group_of);
      Four steps = look_up(kStepOf, symbols);
      if (any(symbols == int{kFarther})) [[unlikely]]
        steps = with_far_steps(steps, symbols);
      const Four value = (predicted + steps) & 0xffff;
      const Four is_measured = symbols != int{kNotMeasured};
      const Four rank = value & is_measured;
      put_four(rows.filled + kLanes * x, value);
      put_four(rows.measured + kLanes * x, rank);
      at = {value, at.west, north, is_measured, rank == was};
    }
  }
};

template <class Vector, bool kDependent>
void decode_slices_together(DecodeSlice* slices, int width, const ContextTables& tables, void* scratch) {
  Together<Vector> together;
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < kLanes; ++i) {
    together.models[i] = take_models(room, tables);
    together.coders[i].start(slices[i].bytes, slices[i].size);
  }
  uint16_t* above = take_rows_together(room, width, 1);
  uint16_t* two_above = take_rows_together(room, width, 1);
  uint16_t* filled = take_rows_together(room, width, 0);
  uint16_t* measured_above = take_rows_together(room, width, 0);
  uint16_t* measured = take_rows_together(room, width, 0);
  auto* const contexts = reinterpret_cast<uint32_t*>(take_rows_together(room, 2 * width + 2 * kMargin, 0));
  uint16_t* const before = take_rows_together(room, width, 0);
  for (int row = 0; row < slices[0].rows; ++row) {
    const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
    classify_above<kLanes>({above, two_above, measured_above}, contexts, kLanes * width);
    if constexpr (kDependent) {
      const uint16_t* const rows[] = {slices[0].before + first, slices[1].before + first, slices[2].before + first,
                                      slices[3].before + first};
      put_together(rows, before, width);
    }
    const RowsTogether rows_together{above, contexts, before, filled, measured};
    if (learning_rate(kDependent, row) == kSettledRate)
      together.template decode_row<kDependent, kSettledRate>(rows_together, width, tables.group_of);
    else
      together.template decode_row<kDependent, kLearningRate>(rows_together, width, tables.group_of);
    uint16_t* const rows[] = {slices[0].ranks + first, slices[1].ranks + first, slices[2].ranks + first,
                              slices[3].ranks + first};
    take_apart(measured, rows, width);
    for (int i = 0; i < kLanes; ++i) {
      filled[i - kLanes] = filled[i - 2 * kLanes] = filled[i];
      filled[kLanes * width + i] = filled[kLanes * (width + 1) + i] = filled[kLanes * (width - 1) + i];
    }
    swap_rows(two_above, above);
    swap_rows(above, filled);
    swap_rows(measured_above, measured);
  }
}

/// As decode(), quicker for four slices of equal height.
template <class Vector>
void decode_together(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  if (count < kLanes || slices[kLanes - 1].rows != slices[0].rows)
    return decode<Vector>(slices, count, width, tables, scratch);
  const auto code =
      slices[0].before != nullptr ? decode_slices_together<Vector, true> : decode_slices_together<Vector, false>;
  code(slices, width, tables, scratch);
}

}  // namespace
}  // namespace telepalp::codec
