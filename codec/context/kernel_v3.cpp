// The only file compiled with -march=x86-64-v3. It must not include the C++ library (why: codec/entropy/range_coder.h).
#include "codec/context/choosing_encoder.h"
#include "codec/context/interleaved_decoder.h"

#if defined(__AVX2__)

#include <immintrin.h>

namespace telepalp::codec {
namespace {

/// Symbol search and model update with AVX2: a model fills one register.
struct Avx2 {
  static int decode(RangeDecoder& coder, const Model& model) {
    const __m256i cdf = _mm256_load_si256(reinterpret_cast<const __m256i*>(model.cdf));
    const __m256i range = _mm256_set1_epi16(static_cast<int16_t>(coder.range));
    const __m256i code = _mm256_set1_epi16(static_cast<int16_t>(coder.code()));
    const __m256i parts = _mm256_mulhi_epu16(_mm256_add_epi16(cdf, cdf), range);
    const __m256i not_above = _mm256_cmpeq_epi16(_mm256_subs_epu16(parts, code), _mm256_setzero_si256());
    const auto places = static_cast<uint32_t>(_mm256_movemask_epi8(not_above)) & 0x3fffffffU;  // two bits each
    const auto twice = static_cast<uint32_t>(_mm_popcnt_u32(places)) - 2;
    alignas(32) uint16_t part_at[16];  // through memory: faster than a second multiplication
    _mm256_store_si256(reinterpret_cast<__m256i*>(part_at), parts);
    uint32_t from_and_to = 0;
    memcpy(&from_and_to, reinterpret_cast<const char*>(part_at) + twice, sizeof from_and_to);
    coder.took(from_and_to & 0xffff, from_and_to >> 16);
    return static_cast<int>(twice >> 1);
  }

  template <int kRate>
  static void learn(Model& model, int symbol) {
    auto* const at = reinterpret_cast<__m256i*>(model.cdf);
    const __m256i cdf = _mm256_load_si256(at);
    const __m256i target = _mm256_load_si256(reinterpret_cast<const __m256i*>(kTargets.of[symbol]));
    _mm256_store_si256(at, _mm256_add_epi16(cdf, _mm256_srai_epi16(_mm256_sub_epi16(target, cdf), kRate)));
  }
};

}  // namespace

extern const ContextKernel* const kV3ContextKernel;
constexpr ContextKernel kKernel{"x86-64-v3", encode_or_choose<Avx2>, decode_interleaved<Avx2>};
const ContextKernel* const kV3ContextKernel = &kKernel;

}  // namespace telepalp::codec

#else

namespace telepalp::codec {

extern const ContextKernel* const kV3ContextKernel;
const ContextKernel* const kV3ContextKernel = nullptr;

}  // namespace telepalp::codec

#endif
