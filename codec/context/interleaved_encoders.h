#pragma once

#include "codec/context/kernel.h"
#include "codec/simd/lane_vector.h"

// LaneVector range coders at work as one. Internal linkage for the same reason as in range_coder.h.

namespace telepalp::codec {
namespace {

using LaneShares [[gnu::vector_size(16)]] = uint32_t;
using LaneWide [[gnu::vector_size(32)]] = uint64_t;

/// A symbol's two places in its model, the upper one in the upper half.
inline uint32_t cumulative_range(const Model& model, uint32_t symbol) {
  uint32_t places = 0;
  memcpy(&places, model.cdf + symbol, sizeof places);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  places = places >> 16 | places << 16;
#endif
  return places;
}

/// Zero bits in front of each of four numbers of 16 bits that are not 0: as their exponents tell.
inline LaneShares leading_zeros16(LaneShares numbers) {
  using Floats [[gnu::vector_size(16)]] = float;
  const auto floats = __builtin_convertvector(reinterpret_cast<LaneVector>(numbers), Floats);
  return 15 + 127 - (reinterpret_cast<LaneShares>(floats) >> 23);
}

/// A step too far for a symbol of its own, behind the symbol that says so.
[[gnu::noinline]] void encode_far(RangeEncoder& coder, Model& model, int step) {
  const int size = step < 0 ? -step : step;
  encode_number(coder, model, static_cast<uint32_t>(size - kLargestStep - 1));
  coder.encode_bits(step < 0 ? 1 : 0, 1);
}

/// Where four coders are addressed one by one.
struct LaneEncoders {
  RangeEncoder* coders[kLanes];
  Model* far_models[kLanes];
};

/// What four coders carry from symbol to symbol, in three registers: the same arithmetic, hence the same bytes.
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

  /// One symbol each, by cumulative_range() it. Whether some coder has a word to put before the next.
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

// Both give what they were given, gone on: so that it need not be in memory but for their sake.

[[gnu::noinline]] InterleavedEncoders with_words_put(const InterleavedEncoders& together,
                                                     const LaneEncoders& encoders) {
  together.store(encoders);
  for (RangeEncoder* coder : encoders.coders)
    if (coder->pending >= 32) coder->put_word();
  InterleavedEncoders after;
  after.load(encoders);
  return after;
}

/// Encodes those of four steps that are too far for a symbol of their own.
[[gnu::noinline]] InterleavedEncoders with_far_steps(const InterleavedEncoders& together, const LaneEncoders& encoders,
                                                     LaneVector steps) {
  together.store(encoders);
  for (int i = 0; i < kLanes; ++i)
    if (steps[i] > kLargestStep || steps[i] < -kLargestStep)
      encode_far(*encoders.coders[i], *encoders.far_models[i], steps[i]);
  InterleavedEncoders after;
  after.load(encoders);
  return after;
}

/// Whether some of four symbols is kFarther, the last there is.
inline bool any_farther(LaneShares places) {
  return any(reinterpret_cast<LaneVector>(places >> 16) == int{kModelTotal});
}

}  // namespace
}  // namespace telepalp::codec
