#include "codec/entropy/range_coder.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace telepalp::codec {
namespace {

constexpr Model kFlat = [] {
  Model model{};
  for (int place = 0; place <= kSymbols; ++place)
    model.cdf[place] = static_cast<uint16_t>(kModelTotal * static_cast<uint32_t>(place) / kSymbols);
  return model;
}();

uint32_t coded(uint32_t number) {
  std::array<uint8_t, 64> bytes{};
  Model model = kFlat;
  RangeEncoder encoder;
  encoder.start(bytes.data(), bytes.size());
  encode_number(encoder, model, number);
  const size_t size = encoder.finish();
  model = kFlat;
  RangeDecoder decoder;
  decoder.start(bytes.data(), size);
  return decode_number(decoder, model);
}

TEST(RangeCoder, EveryNumberUpToTheLargestIsDecodedAsItWasEncoded) {
  for (uint32_t number = 0; number <= kLargestNumber; ++number) ASSERT_EQ(coded(number), number);
}

TEST(RangeCoderDeathTest, ALargerNumberEndsTheProgramInsteadOfBecomingAnotherOne) {
  EXPECT_DEATH((void)coded(kLargestNumber + 1), "");
  EXPECT_DEATH((void)coded(std::numeric_limits<uint32_t>::max()), "");
}

}  // namespace
}  // namespace telepalp::codec
