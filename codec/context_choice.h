#pragma once

#include "codec/slices_together.h"

// Encoding where each pixel may have one of several ranks: of those it takes the one that its model finds cheapest, of
// four slices at once. Internal linkage for the same reason as in range_coder.h.

namespace telepalp::codec {
namespace {

/// Symbols of four steps.
inline Four symbols_for(Four steps) {
  const Four size = greatest(steps, -steps);
  const Four near = size + size - (steps < 0);
  return size > int{kLargestStep} ? Four{} + int{kFarther} : near;
}

/// What one row of all slices may become: 0 and 65 535, so anything, where nothing was measured.
struct RankBounds {
  uint16_t* least = nullptr;
  uint16_t* most = nullptr;
};

/// 1 where the bounds do not have a rank.
inline Stretch missed(Stretch rank, const RankBounds& bounds, int at) {
  const auto apart = (rank < stretch_at(bounds.least + at)) | (rank > stretch_at(bounds.most + at));
  return reinterpret_cast<Stretch>(apart) & 1;
}

/// How often the share of each pixel's least rank is doubled before it is compared, and in the upper half that of its
/// most: twice, less once for each neighbour, to the east and to the south, that cannot have the same.
inline void weigh(const RankBounds& here, const RankBounds& south, uint16_t* weights, int width) {
  for (int i = 0; i < kLanes * width; i += kPlacesAtOnce) {
    const auto weight = [&](Stretch rank) { return 2 - missed(rank, here, i + kLanes) - missed(rank, south, i); };
    const Stretch both = weight(stretch_at(here.least + i)) | weight(stretch_at(here.most + i)) << 8;
    memcpy(weights + i, &both, sizeof both);
  }
}

/// The two ranks that four pixels may take, and their symbols, the first's in the lower byte.
struct Offers {
  Four first, second;
  Four symbols;
  Four is_measured;
};

/// The ends of what is possible; or twice what was predicted, where that lies between them, or nothing was measured.
inline Offers offers_for(Four predicted, const RankBounds& bounds, int x) {
  Offers offers{};
  const Four lowest = four_at(bounds.least + kLanes * x);
  const Four highest = four_at(bounds.most + kLanes * x);
  offers.is_measured = lowest != 0;
  const Four is_given = ((predicted > lowest) & (predicted < highest)) | ~offers.is_measured;
  offers.first = pick(is_given, predicted, lowest);
  offers.second = pick(is_given, predicted, highest);
  const Four symbols = symbols_for(offers.first - predicted) | symbols_for(offers.second - predicted) << 8;
  offers.symbols = (symbols & offers.is_measured) | (~offers.is_measured & kNotMeasured * 0x101);
  return offers;
}

/// Four pixels' models.
struct ModelsApart {
  Model* of[kLanes];
};

/// Places of the first symbol offered to each, or of the second.
template <int kShift>
inline FourShares places_of(const ModelsApart& models, const Apart& offered) {
  const auto places = [&](int lane) { return places_of(*models.of[lane], offered.of[lane] >> kShift & 0xff); };
  return FourShares{places(0), places(1), places(2), places(3)};
}

inline Four shares_of(FourShares places) { return reinterpret_cast<Four>((places >> 16) - (places & 0xffff)); }

template <class Vector>
struct ChoosingEncoder {
  RangeEncoder coders[kLanes];
  Model* models[kLanes];
  Model far_models[kLanes] = {kFlatModel, kFlatModel, kFlatModel, kFlatModel};
  uint8_t nowhere[16];

  /// A lane of which nothing is kept.
  void idle(int lane) {
    coders[lane] = RangeEncoder{};
    coders[lane].start(nowhere, sizeof nowhere);
  }

  EncodersApart encoders() {
    EncodersApart apart;
    for (int i = 0; i < kLanes; ++i) {
      apart.coders[i] = &coders[i];
      apart.far_models[i] = &far_models[i];
    }
    return apart;
  }

  template <bool kDependent>
  ModelsApart models_for(const Outlook& out, const uint8_t* group_of) const {
    const Apart contexts = apart(out.contexts);
    const Apart classes = apart(out.classes);
    ModelsApart found;
    for (int i = 0; i < kLanes; ++i) {
      const uint32_t group = group_of[contexts.of[i]];
      found.of[i] = models[i] + (kDependent ? group * kBeforeClasses + classes.of[i] : group);
    }
    return found;
  }

  /// Each pixel becomes the likelier of the two ranks that it may take, of which one is worth half for each neighbour
  /// that cannot have the same, as that one will differ.
  template <bool kDependent, int kRate>
  void encode_row(const RowsTogether& rows, const RankBounds& bounds, const uint16_t* weights, int width,
                  const uint8_t* group_of) {
    const EncodersApart encoders = this->encoders();
    EncodersTogether together;
    together.load(encoders);
    Neighbours at = neighbours_at_start(rows);
    for (int x = 0; x < width; ++x) {
      const Outlook out = outlook<kDependent>(at, rows, x);
      const ModelsApart found = models_for<kDependent>(out, group_of);
      const Offers offers = offers_for(out.predicted, bounds, x);
      const Apart offered = apart(offers.symbols);
      const FourShares first = places_of<0>(found, offered);
      const FourShares second = places_of<8>(found, offered);
      const Four weight = four_at(weights + kLanes * x);
      const Four takes_second = shares_of(second) << (weight >> 8) > shares_of(first) << (weight & 0xff);
      const FourShares chosen = pick(takes_second, second, first);
      const bool must_put = together.encode(chosen);
      const Apart symbols = apart(pick(takes_second, offers.symbols >> 8, offers.symbols & 0xff));
      for (int i = 0; i < kLanes; ++i) Vector::template learn<kRate>(*found.of[i], static_cast<int>(symbols.of[i]));
      if (must_put) [[unlikely]]
        together = with_words_put(together, encoders);
      const Four value = pick(takes_second, offers.second, offers.first);
      if (any_farther(chosen)) [[unlikely]]
        together = with_far_steps(together, encoders, value - out.predicted);
      step_east(at, rows, x, value, offers.is_measured, out.was);
    }
    together.store(encoders);
  }
};

inline RankBounds take_bounds(uint8_t*& scratch, int width) {
  uint16_t* const least = take_rows_together(scratch, width, 0);
  return {least, take_rows_together(scratch, width, 0xffff)};
}

/// Rows of a slice that is at its end.
struct NoSlice {
  uint16_t* nothing = nullptr;
  uint16_t* anything = nullptr;
  uint16_t* spare = nullptr;
};

inline NoSlice take_no_slice(uint8_t*& scratch, int width) {
  NoSlice taken;
  taken.nothing = take_row(scratch, width);
  taken.anything = take_row(scratch, width);
  taken.spare = take_row(scratch, width);
  for (int x = 0; x < width; ++x) taken.nothing[x] = 0;
  for (int x = 0; x < width; ++x) taken.anything[x] = 0xffff;
  return taken;
}

/// One row of each slice, as the caller has them.
struct RowsApart {
  const uint16_t* least[kLanes];
  const uint16_t* most[kLanes];
  const uint16_t* before[kLanes];
  uint16_t* chosen[kLanes];
};

inline RowsApart rows_at(const EncodeSlice* slices, int count, int row, int width, const NoSlice& none) {
  RowsApart rows;
  const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
  for (int i = 0; i < kLanes; ++i) {
    const bool is_there = i < count && row < slices[i].rows;
    rows.least[i] = is_there ? slices[i].ranks + first : none.nothing;
    rows.most[i] = is_there ? slices[i].most + first : none.anything;
    rows.before[i] = is_there && slices[i].before != nullptr ? slices[i].before + first : none.nothing;
    rows.chosen[i] = is_there ? slices[i].ranks + first : none.spare;
  }
  return rows;
}

inline void put_bounds_together(const RowsApart& apart, const RankBounds& bounds, int width) {
  put_together(apart.least, bounds.least, width);
  put_together(apart.most, bounds.most, width);
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
  HistoryTogether history = take_history(room, width);
  RankBounds here = take_bounds(room, width);
  RankBounds south = take_bounds(room, width);
  uint16_t* const weights = take_rows_together(room, width, 0);
  const NoSlice none = take_no_slice(room, width);
  put_bounds_together(rows_at(slices, count, 0, width, none), south, width);
  for (int row = 0; row < slices[0].rows; ++row) {
    swap_rows(here.least, south.least);
    swap_rows(here.most, south.most);
    put_bounds_together(rows_at(slices, count, row + 1, width, none), south, width);
    weigh(here, south, weights, width);
    const RowsApart apart = rows_at(slices, count, row, width, none);
    const RowsTogether rows = begin_rows(history, kDependent ? &apart.before : nullptr, width);
    if (learning_rate(kDependent, row) == kSettledRate)
      encoder.template encode_row<kDependent, kSettledRate>(rows, here, weights, width, tables.group_of);
    else
      encoder.template encode_row<kDependent, kLearningRate>(rows, here, weights, width, tables.group_of);
    take_apart(rows.measured, apart.chosen, width);
    end_rows(history, width);
    for (int i = 0; i < count; ++i) {
      if (row + 1 != slices[i].rows) continue;
      slices[i].size = encoder.coders[i].finish();
      encoder.idle(i);
    }
  }
}

/// As encode(), or, where slices say what most their pixels may be, with that choice made.
template <class Vector>
void encode_or_choose(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  if (slices[0].most == nullptr) return encode<Vector>(slices, count, width, tables, scratch);
  const auto code = slices[0].before != nullptr ? choose_and_encode<Vector, true> : choose_and_encode<Vector, false>;
  code(slices, count, width, tables, scratch);
}

}  // namespace
}  // namespace telepalp::codec
