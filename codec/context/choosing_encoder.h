#pragma once

#include "codec/context/interleaved_slices.h"

// Near-lossless encoding of four slices in lockstep. A rank is the index of a depth in the palette; each pixel may take
// a range of ranks. The encoder takes the predicted rank if it lies inside the range, else the likelier end of the
// range. A rank's likelihood is halved for each neighbour (east, south) that cannot take it. A gap is a pixel that was
// not measured. All functions have internal linkage, so that the linker keeps one copy for each instruction set.

namespace telepalp::codec {
namespace {

/// The symbols that code four steps, one per lane. A step is the difference between rank and prediction.
inline LaneVector symbols_for(LaneVector steps) {
  const LaneVector size = greatest(steps, -steps);
  const LaneVector near = size + size - (steps < 0);
  return size > int{kLargestStep} ? LaneVector{} + int{kFarther} : near;
}

/// The least and greatest rank that each pixel of one interleaved row may take; 0 and 65 535 (any rank) in gaps.
struct RankBounds {
  uint16_t* least = nullptr;
  uint16_t* most = nullptr;
};

/// 1 where `rank` lies outside the bounds of the pixel `at`, else 0.
inline RowVector missed(RowVector rank, const RankBounds& bounds, int at) {
  const auto outside = (rank < row_vector_at(bounds.least + at)) | (rank > row_vector_at(bounds.most + at));
  return reinterpret_cast<RowVector>(outside) & 1;
}

/// Weights of each pixel's least rank (low byte) and greatest rank (high byte): exponents of the powers of two by which
/// encode_row() multiplies their probabilities. A weight is 2, less 1 for each neighbour (east, south) that cannot take
/// the same rank.
inline void weigh(const RankBounds& here, const RankBounds& south, uint16_t* weights, int width) {
  for (int i = 0; i < kLanes * width; i += kRowVectorPixels) {
    const auto weight = [&](RowVector rank) { return 2 - missed(rank, here, i + kLanes) - missed(rank, south, i); };
    const RowVector both = weight(row_vector_at(here.least + i)) | weight(row_vector_at(here.most + i)) << 8;
    memcpy(weights + i, &both, sizeof both);
  }
}

/// The two candidate ranks of four pixels, and their symbols: the first candidate's in the low byte.
struct RankChoices {
  LaneVector first, second;
  LaneVector symbols;
  LaneVector is_measured;
};

/// The candidates are the two bounds. Where the prediction lies between the bounds, or in a gap, both candidates are
/// the prediction.
inline RankChoices rank_choices(LaneVector predicted, const RankBounds& bounds, int x) {
  RankChoices offers{};
  const LaneVector lowest = lanes_at(bounds.least + kLanes * x);
  const LaneVector highest = lanes_at(bounds.most + kLanes * x);
  offers.is_measured = lowest != 0;
  const LaneVector is_given = ((predicted > lowest) & (predicted < highest)) | ~offers.is_measured;
  offers.first = pick(is_given, predicted, lowest);
  offers.second = pick(is_given, predicted, highest);
  const LaneVector symbols = symbols_for(offers.first - predicted) | symbols_for(offers.second - predicted) << 8;
  offers.symbols = (symbols & offers.is_measured) | (~offers.is_measured & kNotMeasured * 0x101);
  return offers;
}

/// The models of four pixels, one per lane.
struct LaneModels {
  Model* of[kLanes];
};

/// The cumulative ranges of each lane's first candidate symbol (kShift = 0) or second one (kShift = 8).
template <int kShift>
inline LaneShares cumulative_range(const LaneModels& models, const PerLane& offered) {
  const auto places = [&](int lane) { return cumulative_range(*models.of[lane], offered.of[lane] >> kShift & 0xff); };
  return LaneShares{places(0), places(1), places(2), places(3)};
}

inline LaneVector shares_of(LaneShares places) {
  return reinterpret_cast<LaneVector>((places >> 16) - (places & 0xffff));
}

template <class Vector>
struct ChoosingEncoder {
  RangeEncoder coders[kLanes];
  Model* models[kLanes];
  Model far_models[kLanes] = {kFlatModel, kFlatModel, kFlatModel, kFlatModel};
  uint8_t nowhere[16];

  /// Points a lane without a slice at a dummy buffer; its output is discarded.
  void idle(int lane) {
    coders[lane] = RangeEncoder{};
    coders[lane].start(nowhere, sizeof nowhere);
  }

  LaneEncoders encoders() {
    LaneEncoders all;
    for (int i = 0; i < kLanes; ++i) {
      all.coders[i] = &coders[i];
      all.far_models[i] = &far_models[i];
    }
    return all;
  }

  template <bool kDependent>
  LaneModels models_for(const PixelPrediction& out, const uint8_t* group_of) const {
    const PerLane contexts = per_lane(out.contexts);
    const PerLane classes = per_lane(out.classes);
    LaneModels found;
    for (int i = 0; i < kLanes; ++i) {
      const uint32_t group = group_of[contexts.of[i]];
      found.of[i] = models[i] + (kDependent ? group * kBeforeClasses + classes.of[i] : group);
    }
    return found;
  }

  /// Each pixel takes the likelier of its two candidate ranks. A candidate's likelihood is halved for each neighbour
  /// that cannot take the same rank, because coding that neighbour costs a step to another rank.
  template <bool kDependent, int kRate>
  void encode_row(const InterleavedRows& rows, const RankBounds& bounds, const uint16_t* weights, int width,
                  const uint8_t* group_of) {
    const LaneEncoders encoders = this->encoders();
    InterleavedEncoders lanes;
    lanes.load(encoders);
    Neighbours at = neighbours_at_start(rows);
    for (int x = 0; x < width; ++x) {
      const PixelPrediction out = predict_pixel<kDependent>(at, rows, x);
      const LaneModels found = models_for<kDependent>(out, group_of);
      const RankChoices offers = rank_choices(out.predicted, bounds, x);
      const PerLane offered = per_lane(offers.symbols);
      const LaneShares first = cumulative_range<0>(found, offered);
      const LaneShares second = cumulative_range<8>(found, offered);
      const LaneVector weight = lanes_at(weights + kLanes * x);
      const LaneVector takes_second = shares_of(second) << (weight >> 8) > shares_of(first) << (weight & 0xff);
      const LaneShares chosen = pick(takes_second, second, first);
      const bool must_put = lanes.encode(chosen);
      const PerLane symbols = per_lane(pick(takes_second, offers.symbols >> 8, offers.symbols & 0xff));
      for (int i = 0; i < kLanes; ++i) Vector::template learn<kRate>(*found.of[i], static_cast<int>(symbols.of[i]));
      if (must_put) [[unlikely]]
        lanes = with_words_put(lanes, encoders);
      const LaneVector value = pick(takes_second, offers.second, offers.first);
      if (any_farther(chosen)) [[unlikely]]
        lanes = with_far_steps(lanes, encoders, value - out.predicted);
      step_east(at, rows, x, value, offers.is_measured, out.was);
    }
    lanes.store(encoders);
  }
};

inline RankBounds take_bounds(uint8_t*& scratch, int width) {
  uint16_t* const least = take_interleaved_rows(scratch, width, 0);
  return {least, take_interleaved_rows(scratch, width, 0xffff)};
}

/// Stands in for the rows of a slice that has ended, or of a lane without a slice.
struct PaddingRows {
  uint16_t* zeros = nullptr;
  uint16_t* ones = nullptr;     ///< every bit set: 65 535
  uint16_t* scratch = nullptr;  ///< written and never read
};

inline PaddingRows take_padding_rows(uint8_t*& scratch, int width) {
  PaddingRows taken;
  taken.zeros = take_row(scratch, width);
  taken.ones = take_row(scratch, width);
  taken.scratch = take_row(scratch, width);
  for (int x = 0; x < width; ++x) taken.zeros[x] = 0;
  for (int x = 0; x < width; ++x) taken.ones[x] = 0xffff;
  return taken;
}

/// One row of each slice, as the caller stores it: not interleaved.
struct LaneRows {
  const uint16_t* least[kLanes];
  const uint16_t* most[kLanes];
  const uint16_t* before[kLanes];
  uint16_t* chosen[kLanes];
};

inline LaneRows rows_at(const EncodeSlice* slices, int count, int row, int width, const PaddingRows& padding) {
  LaneRows rows;
  const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
  for (int i = 0; i < kLanes; ++i) {
    const bool is_there = i < count && row < slices[i].rows;
    rows.least[i] = is_there ? slices[i].ranks + first : padding.zeros;
    rows.most[i] = is_there ? slices[i].most + first : padding.ones;
    rows.before[i] = is_there && slices[i].before != nullptr ? slices[i].before + first : padding.zeros;
    rows.chosen[i] = is_there ? slices[i].ranks + first : padding.scratch;
  }
  return rows;
}

inline void interleave_bounds(const LaneRows& lane_rows, const RankBounds& bounds, int width) {
  interleave_rows(lane_rows.least, bounds.least, width);
  interleave_rows(lane_rows.most, bounds.most, width);
}

template <class Vector, bool kDependent>
void choose_and_encode(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  ChoosingEncoder<Vector> encoder;
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < kLanes; ++i) {
    encoder.models[i] = take_models(room, tables);
    encoder.idle(i);
    if (i < count) encoder.coders[i].start(slices[i].bytes, slices[i].room);
  }
  InterleavedHistory history = take_history(room, width);
  RankBounds here = take_bounds(room, width);
  RankBounds south = take_bounds(room, width);
  uint16_t* const weights = take_interleaved_rows(room, width, 0);
  const PaddingRows padding = take_padding_rows(room, width);
  interleave_bounds(rows_at(slices, count, 0, width, padding), south, width);
  for (int row = 0; row < slices[0].rows; ++row) {
    swap_rows(here.least, south.least);
    swap_rows(here.most, south.most);
    interleave_bounds(rows_at(slices, count, row + 1, width, padding), south, width);
    weigh(here, south, weights, width);
    const LaneRows lane_rows = rows_at(slices, count, row, width, padding);
    const InterleavedRows rows = begin_rows(history, kDependent ? &lane_rows.before : nullptr, width);
    if (learning_rate(kDependent, row) == kSettledRate)
      encoder.template encode_row<kDependent, kSettledRate>(rows, here, weights, width, tables.group_of);
    else
      encoder.template encode_row<kDependent, kLearningRate>(rows, here, weights, width, tables.group_of);
    deinterleave_rows(rows.measured, lane_rows.chosen, width);
    end_rows(history, width);
    for (int i = 0; i < count; ++i) {
      if (row + 1 != slices[i].rows) continue;
      slices[i].size = encoder.coders[i].finish();
      encoder.idle(i);
    }
  }
}

/// Encodes near-losslessly if the slices have the greatest rank of each pixel (`most`), else losslessly.
template <class Vector>
void encode_or_choose(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  if (slices[0].most == nullptr) return encode<Vector>(slices, count, width, tables, scratch);
  const auto code = slices[0].before != nullptr ? choose_and_encode<Vector, true> : choose_and_encode<Vector, false>;
  code(slices, count, width, tables, scratch);
}

}  // namespace
}  // namespace telepalp::codec
