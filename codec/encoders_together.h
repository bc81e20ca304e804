#pragma once

#include "codec/context_kernel.h"
#include "codec/four.h"

// Four range coders at work as one. Internal linkage for the same reason as in range_coder.h.

namespace telepalp::codec {
namespace {

using FourShares [[gnu::vector_size(16)]] = uint32_t;
using FourWide [[gnu::vector_size(32)]] = uint64_t;

/// A symbol's two places in its model, the upper one in the upper half.
inline uint32_t places_of(const Model& model, uint32_t symbol) {
  uint32_t places = 0;
  memcpy(&places, model.cdf + symbol, sizeof places);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  places = places >> 16 | places << 16;
#endif
  return places;
}

/// Zero bits in front of each of four numbers of 16 bits that are not 0: as their exponents tell.
inline FourShares leading_zeros16(FourShares numbers) {
  using Floats [[gnu::vector_size(16)]] = float;
  const auto floats = __builtin_convertvector(reinterpret_cast<Four>(numbers), Floats);
  return 15 + 127 - (reinterpret_cast<FourShares>(floats) >> 23);
}

/// A step too far for a symbol of its own, behind the symbol that says so.
[[gnu::noinline]] void encode_far(RangeEncoder& coder, Model& model, int step) {
  const int size = step < 0 ? -step : step;
  encode_number(coder, model, static_cast<uint32_t>(size - kLargestStep - 1));
  coder.encode_bits(step < 0 ? 1 : 0, 1);
}

/// Where four coders are told apart.
struct EncodersApart {
  RangeEncoder* coders[kLanes];
  Model* far_models[kLanes];
};

/// What four coders carry from symbol to symbol, in three registers: the same arithmetic, hence the same bytes.
struct EncodersTogether {
  FourShares range;
  FourShares pending;
  FourWide low;

  void load(const EncodersApart& encoders) {
    for (int i = 0; i < kLanes; ++i) {
      range[i] = encoders.coders[i]->range;
      pending[i] = static_cast<uint32_t>(encoders.coders[i]->pending);
      low[i] = encoders.coders[i]->low;
    }
  }

  void store(const EncodersApart& encoders) const {
    for (int i = 0; i < kLanes; ++i) {
      encoders.coders[i]->range = range[i];
      encoders.coders[i]->pending = static_cast<int>(pending[i]);
      encoders.coders[i]->low = low[i];
    }
  }

  /// One symbol each, by places_of() it. Whether some coder has a word to put before the next.
  bool encode(FourShares places) {
    const FourShares twice = range + range;
    const FourShares skipped = (twice * (places & 0xffff)) >> 16;
    range = ((twice * (places >> 16)) >> 16) - skipped;
    const FourShares shift = leading_zeros16(range);
    range <<= shift;
    low = (low + __builtin_convertvector(skipped, FourWide)) << __builtin_convertvector(shift, FourWide);
    pending += shift;
    return any(reinterpret_cast<Four>(pending) > 31);
  }
};

// Both give what they were given, gone on: so that it need not be in memory but for their sake.

[[gnu::noinline]] EncodersTogether with_words_put(const EncodersTogether& together, const EncodersApart& encoders) {
  together.store(encoders);
  for (RangeEncoder* coder : encoders.coders)
    if (coder->pending >= 32) coder->put_word();
  EncodersTogether after;
  after.load(encoders);
  return after;
}

/// Encodes those of four steps that are too far for a symbol of their own.
[[gnu::noinline]] EncodersTogether with_far_steps(const EncodersTogether& together, const EncodersApart& encoders,
                                                  Four steps) {
  together.store(encoders);
  for (int i = 0; i < kLanes; ++i)
    if (steps[i] > kLargestStep || steps[i] < -kLargestStep)
      encode_far(*encoders.coders[i], *encoders.far_models[i], steps[i]);
  EncodersTogether after;
  after.load(encoders);
  return after;
}

/// Whether some of four symbols is kFarther, the last there is.
inline bool any_farther(FourShares places) { return any(reinterpret_cast<Four>(places >> 16) == int{kModelTotal}); }

}  // namespace
}  // namespace telepalp::codec
