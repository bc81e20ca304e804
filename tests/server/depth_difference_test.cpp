#include "tools/codec_tool/depth_difference.h"

#include <gtest/gtest.h>

namespace telepalp::server {
namespace {

DepthImage row(std::vector<std::uint16_t> samples, double unit_m = 0.001) {
  return {.width = static_cast<int>(samples.size()), .height = 1, .unit_m = unit_m, .samples = std::move(samples)};
}

const DepthErrorBound kBound{.least_m = 0.001, .per_m = 0.003};  // 3 mm at 1 m, 12 mm at 2 m

TEST(DepthDifference, AllowsEachPixelWhatItsOriginalDepthAllowsAndNoMore) {
  const DepthImage original = row({400, 1000, 2000});
  codec_tool::DepthDifference held(kBound);
  held.add(original, row({401, 997, 2012}));
  EXPECT_EQ(held.beyond(), 0u) << held.first_beyond();
  EXPECT_EQ(held.worst_mm(), 12.0);
  for (const DepthImage& beyond : {row({402, 1000, 2000}), row({400, 1004, 2000}), row({400, 1000, 1987})}) {
    codec_tool::DepthDifference difference(kBound);
    difference.add(original, beyond);
    EXPECT_EQ(difference.beyond(), 1u);
  }
}

TEST(DepthDifference, NamesTheFirstPixelBeyondTheBound) {
  codec_tool::DepthDifference difference(kBound);
  const DepthImage original{.width = 2, .height = 2, .unit_m = 0.001, .samples = {0, 0, 0, 1000}};
  DepthImage other = original;
  difference.add(original, other);
  other.samples[3] = 1005;
  difference.add(original, other);
  difference.add(original, other);
  EXPECT_EQ(difference.beyond(), 2u);
  EXPECT_EQ(difference.first_beyond(),
            "frame 1, column 1, row 1 (counted from 0) at 1000.000 mm: off by 5.000 mm, 3.000 mm allowed");
}

TEST(DepthDifference, APixelThatOnlyOneMeasuredIsBeyondAnyBound) {
  codec_tool::DepthDifference difference(DepthErrorBound{.least_m = 100.0, .per_m = 100.0});
  difference.add(row({0, 700, 0}), row({700, 0, 0}));
  EXPECT_EQ(difference.flips(), 2u);
  EXPECT_EQ(difference.beyond(), 2u);
  EXPECT_EQ(difference.first_beyond(),
            "frame 0, column 0, row 0 (counted from 0): not measured in the first input, 700.000 mm in the second");
  EXPECT_EQ(difference.measured(), 0u);
  EXPECT_EQ(difference.rms_mm(), 0.0);
}

TEST(DepthDifference, ComparesMillimetresWhateverTheUnits) {
  codec_tool::DepthDifference difference(DepthErrorBound{.least_m = 0.0, .per_m = 0.0});
  difference.add(row({1000, 500}), row({8000, 4000}, 0.000125));
  EXPECT_EQ(difference.beyond(), 0u) << difference.first_beyond();
  EXPECT_EQ(difference.measured(), 2u);
}

TEST(DepthDifference, WithoutABoundNothingIsBeyondIt) {
  codec_tool::DepthDifference difference;
  difference.add(row({1000, 1}), row({3000, 0}));
  EXPECT_EQ(difference.beyond(), 0u);
  EXPECT_EQ(difference.worst_mm(), 2000.0);
}

}  // namespace
}  // namespace telepalp::server
