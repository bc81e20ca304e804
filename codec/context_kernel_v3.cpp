// Compiled with -march=x86-64-v3, alone. Nothing of the C++ library may be included here: see range_coder.h.
#include "codec/context_kernel_impl.h"

#if defined(__AVX2__)

#include <immintrin.h>

namespace telepalp::codec {
namespace {

/// A model is one register.
struct Avx2 {
  static int decode(RangeDecoder& coder, const Model& model) {
    const __m256i cdf = _mm256_load_si256(reinterpret_cast<const __m256i*>(model.cdf));
    const __m256i range = _mm256_set1_epi16(static_cast<int16_t>(coder.range));
    const __m256i code = _mm256_set1_epi16(static_cast<int16_t>(coder.code()));
    const __m256i parts = _mm256_mulhi_epu16(_mm256_add_epi16(cdf, cdf), range);
    const __m256i not_above = _mm256_cmpeq_epi16(_mm256_subs_epu16(parts, code), _mm256_setzero_si256());
    const uint32_t above = ~static_cast<uint32_t>(_mm256_movemask_epi8(not_above)) | 0x40000000U;
    const int symbol = static_cast<int>(_tzcnt_u32(above) >> 1) - 1;
    coder.took(part(coder.range, model.cdf[symbol]), part(coder.range, model.cdf[symbol + 1]));
    return symbol;
  }

  static void learn(Model& model, int symbol) {
    auto* const at = reinterpret_cast<__m256i*>(model.cdf);
    const __m256i cdf = _mm256_load_si256(at);
    const __m256i target = _mm256_load_si256(reinterpret_cast<const __m256i*>(kTargets.of[symbol]));
    _mm256_store_si256(at, _mm256_add_epi16(cdf, _mm256_srai_epi16(_mm256_sub_epi16(target, cdf), kLearningRate)));
  }
};

/// Rows of all four slices in one: four numbers a pixel.
uint16_t* take_rows_together(uint8_t*& scratch, int width, uint16_t value) {
  const size_t numbers = kLanes * row_bytes(width) / sizeof(uint16_t);
  auto* const rows = reinterpret_cast<uint16_t*>(scratch);
  for (size_t i = 0; i < numbers; ++i) rows[i] = value;
  scratch += numbers * sizeof(uint16_t);
  return rows + kLanes * kMargin;
}

/// context_from_above() of four slices.
void contexts_from_above(const uint16_t* filled, const uint16_t* measured, uint16_t* context, int width) {
  TELEPALP_INDEPENDENT_TURNS
  for (int i = 0; i < kLanes * width; ++i) {
    const int classes = 25 * (bounded(filled[i + kLanes] - filled[i], 2) + 2) +
                        kNorthClass * (bounded(filled[i] - filled[i - kLanes], 2) + 2);
    const int flags =
        (measured[i] != 0 ? 1 : 0) + (measured[i - kLanes] != 0 ? 2 : 0) + (measured[i + kLanes] != 0 ? 4 : 0);
    context[i] = static_cast<uint16_t>(classes + kNorthMeasured * flags);
  }
}

__m128i four_of(const uint16_t* at) {
  return _mm_cvtepu16_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(at)));
}

void put_four(uint16_t* at, __m128i numbers) {
  _mm_storel_epi64(reinterpret_cast<__m128i*>(at), _mm_packus_epi32(numbers, numbers));
}

__m128i bounded_by_two(__m128i value) {
  return _mm_max_epi32(_mm_min_epi32(value, _mm_set1_epi32(2)), _mm_set1_epi32(-2));
}

__m128i predict_four(__m128i west, __m128i north, __m128i north_west) {
  const __m128i slope = _mm_sub_epi32(_mm_add_epi32(west, north), north_west);
  return _mm_max_epi32(_mm_min_epi32(slope, _mm_max_epi32(west, north)), _mm_min_epi32(west, north));
}

/// before_class() of four slices.
__m128i before_classes(__m128i before, __m128i predicted, __m128i west_stayed) {
  const __m128i away = _mm_add_epi32(bounded_by_two(_mm_sub_epi32(before, predicted)), _mm_set1_epi32(2));
  const __m128i one = _mm_set1_epi32(1);
  const __m128i known = _mm_add_epi32(_mm_add_epi32(_mm_slli_epi32(away, 1), one), _mm_and_si128(west_stayed, one));
  return _mm_andnot_si128(_mm_cmpeq_epi32(before, _mm_setzero_si128()), known);
}

/// What four slices carry from pixel to pixel, a register each.
struct Neighbours {
  __m128i west, west_west, north_west;
  __m128i west_measured, west_stayed;  // all bits or none
};

/// Decodes four slices of equal height at once: their neighbours, predictions and contexts lie in one register each,
/// and only the symbols are found one by one.
struct Together {
  RangeDecoder coders[kLanes];
  Model* models[kLanes];
  Model far_models[kLanes] = {kFlatModel, kFlatModel, kFlatModel, kFlatModel};

  [[gnu::noinline]] __m128i with_far_steps(__m128i steps, __m128i symbols) {
    alignas(16) int32_t step[kLanes];
    alignas(16) int32_t symbol[kLanes];
    _mm_store_si128(reinterpret_cast<__m128i*>(step), steps);
    _mm_store_si128(reinterpret_cast<__m128i*>(symbol), symbols);
    for (int i = 0; i < kLanes; ++i)
      if (symbol[i] == kFarther) step[i] = decode_far(coders[i], far_models[i]);
    return _mm_load_si128(reinterpret_cast<const __m128i*>(step));
  }

  int symbol_of(int lane, int model) {
    Model& at = models[lane][model];
    const int symbol = Avx2::decode(coders[lane], at);
    Avx2::learn(at, symbol);
    return symbol;
  }

  template <bool kDependent>
  __m128i symbols_of(__m128i contexts, __m128i classes, const uint8_t* cluster_of) {
    const auto model = [&](int context, int of_before) {
      const int cluster = cluster_of[context];
      return kDependent ? cluster * kBeforeClasses + of_before : cluster;
    };
    const int first = symbol_of(0, model(_mm_cvtsi128_si32(contexts), _mm_cvtsi128_si32(classes)));
    const int second = symbol_of(1, model(_mm_extract_epi32(contexts, 1), _mm_extract_epi32(classes, 1)));
    const int third = symbol_of(2, model(_mm_extract_epi32(contexts, 2), _mm_extract_epi32(classes, 2)));
    const int fourth = symbol_of(3, model(_mm_extract_epi32(contexts, 3), _mm_extract_epi32(classes, 3)));
    return _mm_setr_epi32(first, second, third, fourth);
  }

  template <bool kDependent>
  void decode_row(const uint16_t* above, const uint16_t* context_above, const uint16_t* before, uint16_t* filled,
                  uint16_t* measured, int width, const uint8_t* cluster_of) {
    const __m128i steps_of = _mm_setr_epi8(0, 0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 0, 0);  // kStepOf
    const __m128i nothing = _mm_setzero_si128();
    const __m128i start = four_of(above);
    Neighbours at{start, start, start, nothing, nothing};
    for (int x = 0; x < width; ++x) {
      const __m128i north = four_of(above + kLanes * x);
      const __m128i predicted = predict_four(at.west, north, at.north_west);
      const __m128i from_west = bounded_by_two(_mm_sub_epi32(at.west_west, at.west));
      const __m128i from_north = bounded_by_two(_mm_sub_epi32(at.west, at.north_west));
      const __m128i five_from_north = _mm_add_epi32(_mm_slli_epi32(from_north, 2), from_north);  // kWestClass
      const __m128i flag = _mm_and_si128(at.west_measured, _mm_set1_epi32(kWestMeasured));
      const __m128i middle = _mm_set1_epi32(2 + 2 * kWestClass);
      const __m128i contexts = _mm_add_epi32(_mm_add_epi32(four_of(context_above + kLanes * x), middle),
                                             _mm_add_epi32(_mm_add_epi32(from_west, five_from_north), flag));
      const __m128i was = kDependent ? four_of(before + kLanes * x) : nothing;
      const __m128i classes = kDependent ? before_classes(was, predicted, at.west_stayed) : nothing;
      const __m128i symbols = symbols_of<kDependent>(contexts, classes, cluster_of);
      __m128i steps = _mm_srai_epi32(_mm_slli_epi32(_mm_shuffle_epi8(steps_of, symbols), 24), 24);
      const __m128i is_far = _mm_cmpeq_epi32(symbols, _mm_set1_epi32(kFarther));
      if (_mm_movemask_epi8(is_far) != 0) [[unlikely]]
        steps = with_far_steps(steps, symbols);
      const __m128i value = _mm_and_si128(_mm_add_epi32(predicted, steps), _mm_set1_epi32(0xffff));
      const __m128i is_gap = _mm_cmpeq_epi32(symbols, _mm_set1_epi32(kNotMeasured));
      const __m128i rank = _mm_andnot_si128(is_gap, value);
      put_four(filled + kLanes * x, value);
      put_four(measured + kLanes * x, rank);
      at = {value, at.west, north, _mm_xor_si128(is_gap, _mm_set1_epi32(-1)), _mm_cmpeq_epi32(rank, was)};
    }
  }
};
static_assert(kLanes == 4 && kWestClass == 5);

template <bool kDependent>
void decode_together(DecodeSlice* slices, int width, const ContextTables& tables, void* scratch) {
  Together together;
  auto* room = static_cast<uint8_t*>(scratch);
  for (int i = 0; i < kLanes; ++i) {
    together.models[i] = take_models(room, tables);
    together.coders[i].start(slices[i].bytes, slices[i].size);
  }
  uint16_t* above = take_rows_together(room, width, 1);
  uint16_t* filled = take_rows_together(room, width, 0);
  uint16_t* measured_above = take_rows_together(room, width, 0);
  uint16_t* measured = take_rows_together(room, width, 0);
  uint16_t* const contexts = take_rows_together(room, width, 0);
  uint16_t* const before = take_rows_together(room, width, 0);
  for (int row = 0; row < slices[0].rows; ++row) {
    const size_t first = static_cast<size_t>(row) * static_cast<size_t>(width);
    contexts_from_above(above, measured_above, contexts, width);
    if constexpr (kDependent)
      for (int i = 0; i < kLanes; ++i)
        for (int x = 0; x < width; ++x) before[kLanes * x + i] = slices[i].before[first + static_cast<size_t>(x)];
    together.decode_row<kDependent>(above, contexts, before, filled, measured, width, tables.cluster_of);
    for (int i = 0; i < kLanes; ++i) {
      for (int x = 0; x < width; ++x) slices[i].ranks[first + static_cast<size_t>(x)] = measured[kLanes * x + i];
      filled[i - kLanes] = filled[i];
      filled[kLanes * width + i] = filled[kLanes * (width - 1) + i];
    }
    uint16_t* const filled_now = filled;
    filled = above;
    above = filled_now;
    uint16_t* const measured_now = measured;
    measured = measured_above;
    measured_above = measured_now;
  }
}

void decode_v3(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch) {
  if (count < kLanes || slices[kLanes - 1].rows != slices[0].rows)
    return decode<Avx2>(slices, count, width, tables, scratch);
  const auto code = slices[0].before != nullptr ? decode_together<true> : decode_together<false>;
  code(slices, width, tables, scratch);
}

}  // namespace

extern const ContextKernel* const kV3ContextKernel;
constexpr ContextKernel kKernel{"x86-64-v3", encode<Avx2>, decode_v3};
const ContextKernel* const kV3ContextKernel = &kKernel;

}  // namespace telepalp::codec

#else

namespace telepalp::codec {

extern const ContextKernel* const kV3ContextKernel;
const ContextKernel* const kV3ContextKernel = nullptr;

}  // namespace telepalp::codec

#endif
