#pragma once

#include "codec/context/kernel.h"
#include "codec/simd/lane_vector.h"

// Four range encoders in lockstep, in SIMD registers. All functions have internal linkage, so that the linker keeps
// one copy for each instruction set.

namespace telepalp::codec {
namespace {

using LaneShares [[gnu::vector_size(16)]] = uint32_t;
using LaneWide [[gnu::vector_size(32)]] = uint64_t;

/// The cumulative frequencies that bound a symbol: the lower one in the low 16 bits, the upper one in the high 16 bits.
inline uint32_t cumulative_range(const Model& model, uint32_t symbol) {
  uint32_t places = 0;
  memcpy(&places, model.cdf + symbol, sizeof places);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  places = places >> 16 | places << 16;
#endif
  return places;
}

/// Leading zero bits of four nonzero 16-bit numbers, read off the exponents of their float conversions.
inline LaneShares leading_zeros16(LaneShares numbers) {
  using Floats [[gnu::vector_size(16)]] = float;
  const auto floats = __builtin_convertvector(reinterpret_cast<LaneVector>(numbers), Floats);
  return 15 + 127 - (reinterpret_cast<LaneShares>(floats) >> 23);
}

/// Encodes a step beyond kLargestStep: its size and sign. A step is a pixel's rank (palette index of its depth) minus
/// the predicted rank. The escape symbol kFarther precedes it.
[[gnu::noinline]] void encode_far(RangeEncoder& coder, Model& model, int step) {
  const int size = step < 0 ? -step : step;
  encode_number(coder, model, static_cast<uint32_t>(size - kLargestStep - 1));
  coder.encode_bits(step < 0 ? 1 : 0, 1);
}

/// The four encoders and their models for far steps, addressed lane by lane.
struct LaneEncoders {
  RangeEncoder* coders[kLanes];
  Model* far_models[kLanes];
};

/// The state of four RangeEncoders in three registers. The arithmetic and the bytes are those of RangeEncoder.
struct InterleavedEncoders {
  LaneShares range;
  LaneShares pending;
  LaneWide low;

  void load(const LaneEncoders& encoders) {
    for (int i = 0; i < kLanes; ++i) {
      range[i] = encoders.coders[i]->range;
      pending[i] = static_cast<uint32_t>(encoders.coders[i]->pending);
      low[i] = encoders.coders[i]->low;
    }
  }

  void store(const LaneEncoders& encoders) const {
    for (int i = 0; i < kLanes; ++i) {
      encoders.coders[i]->range = range[i];
      encoders.coders[i]->pending = static_cast<int>(pending[i]);
      encoders.coders[i]->low = low[i];
    }
  }

  /// Encodes one symbol per lane, given by its cumulative_range(). True: some encoder must output a word before the
  /// next symbol.
  bool encode(LaneShares places) {
    const LaneShares twice = range + range;
    const LaneShares skipped = (twice * (places & 0xffff)) >> 16;
    range = ((twice * (places >> 16)) >> 16) - skipped;
    const LaneShares shift = leading_zeros16(range);
    range <<= shift;
    low = (low + __builtin_convertvector(skipped, LaneWide)) << __builtin_convertvector(shift, LaneWide);
    pending += shift;
    return any(reinterpret_cast<LaneVector>(pending) > 31);
  }
};

// Both functions below return the advanced encoder state by value, so that it stays in registers.

[[gnu::noinline]] InterleavedEncoders with_words_put(const InterleavedEncoders& lanes, const LaneEncoders& encoders) {
  lanes.store(encoders);
  for (RangeEncoder* coder : encoders.coders)
    if (coder->pending >= 32) coder->put_word();
  InterleavedEncoders after;
  after.load(encoders);
  return after;
}

/// Encodes, lane by lane, the steps beyond kLargestStep.
[[gnu::noinline]] InterleavedEncoders with_far_steps(const InterleavedEncoders& lanes, const LaneEncoders& encoders,
                                                     LaneVector steps) {
  lanes.store(encoders);
  for (int i = 0; i < kLanes; ++i)
    if (steps[i] > kLargestStep || steps[i] < -kLargestStep)
      encode_far(*encoders.coders[i], *encoders.far_models[i], steps[i]);
  InterleavedEncoders after;
  after.load(encoders);
  return after;
}

/// True when one of four symbols is kFarther: it is the last symbol, so its upper cumulative frequency is the total.
inline bool any_farther(LaneShares places) {
  return any(reinterpret_cast<LaneVector>(places >> 16) == int{kModelTotal});
}

}  // namespace
}  // namespace telepalp::codec
