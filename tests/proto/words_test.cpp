#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <thread>

#include "proto/words/error_line.h"
#include "proto/words/frames.h"
#include "proto/words/latest_value.h"
#include "proto/words/little_endian.h"
#include "proto/words/number_word.h"
#include "proto/words/numbers/number_row.h"
#include "proto/words/numbers/quantile.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/rotation_vector.h"
#include "proto/words/smooth_step.h"
#include "proto/words/spsc_ring.h"

namespace telepalp {
namespace {

TEST(ErrorLine, GivesBackWhatAndFixOfAPrintedError) {
  const Error error = error_in(to_string({.what = "bert holds the touch", .where = {}, .fix = "wait"}));
  EXPECT_EQ(error.what, "bert holds the touch");
  EXPECT_EQ(error.fix, "wait");
  EXPECT_EQ(error_in("closed").what, "closed");
  EXPECT_EQ(error_in("closed").fix, "");
}

TEST(ErrorLine, TheFirstLineEndsAtALineBreak) {
  EXPECT_EQ(first_line("Expected a value.\n\n^"), "Expected a value.");
  EXPECT_EQ(first_line("one line"), "one line");
}

TEST(ErrorLine, ANumberIsShownWithAllItsDigitsAndWithoutAnExponent) {
  EXPECT_EQ(number_text(1e-6), "0.000001");
  EXPECT_EQ(number_text(1e7), "10000000");
  EXPECT_EQ(number_text(-0.5), "-0.5");
  EXPECT_EQ(number_text(5000.0001), "5000.0001");
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
}

TEST(NumberWord, TheWholeTextSpellsTheNumber) {
  EXPECT_EQ(number_of("-2.5e3"), -2500.0);
  EXPECT_EQ(number_of<std::uint64_t>("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  for (const char* text : {"", " 1", "1 ", "1,5", "1m", "+1", "0x10", "1e999"}) EXPECT_FALSE(number_of(text)) << text;
  EXPECT_FALSE(number_of<int>("1.5"));
  EXPECT_TRUE(number_of("inf"));
  EXPECT_FALSE(finite_number_of("inf"));
  EXPECT_FALSE(finite_number_of("nan"));
  EXPECT_EQ(finite_number_of("7"), 7.0);
  EXPECT_EQ(signed_number_of("+1.5"), 1.5);
  EXPECT_FALSE(signed_number_of("++1"));
}

TEST(NumberRow, HasExactlyItsNumbersAndALineIsTakenWithoutItsEnd) {
  EXPECT_EQ(number_row<3>("1,-2.5,3e1"), (std::array{1.0, -2.5, 30.0}));
  for (const char* line : {"", "1,2", "1,2,3,4", "1,2,3,", "1,,3", "1, 2,3", "1,2,inf", "1;2;3", "1,5,2,5,3,5"})
    EXPECT_FALSE(number_row<3>(line)) << line;
  std::string_view text = "first\r\n\nlast";
  EXPECT_EQ(take_line(text), "first");
  EXPECT_EQ(take_line(text), "");
  EXPECT_EQ(take_line(text), "last");
  EXPECT_TRUE(text.empty());
}

TEST(Quantile, IsTheFirstValueThatIsAtLeastAsLargeAsItsShareOfAll) {
  std::vector<double> values{5, 1, 4, 2, 3};
  EXPECT_EQ(quantile_of(values, 0.0), 1.0);
  EXPECT_EQ(quantile_of(values, 0.2), 1.0);
  EXPECT_EQ(quantile_of(values, 0.21), 2.0);
  EXPECT_EQ(quantile_of(values, 0.99), 5.0);
  EXPECT_EQ(quantile_of(values, 1.0), 5.0);
  EXPECT_EQ(median_of(values), 3.0);
  values = {7, 9};
  EXPECT_EQ(median_of(values), 9.0) << "of an even number, the larger one";
  EXPECT_EQ(quantile_of(values, 0.5), 7.0);
}

TEST(LittleEndian, WritesTheLowestByteFirstAndReadsItBack) {
  std::string bytes(1, '\x01');
  append_little_endian<std::uint32_t>(bytes, 0xa1b2c3d4);
  append_little_endian<float>(bytes, 1.0F);
  EXPECT_EQ(bytes, std::string("\x01\xd4\xc3\xb2\xa1\x00\x00\x80\x3f", 9));
  put_little_endian<std::int16_t>(bytes.data(), -2);
  EXPECT_EQ(bytes.substr(0, 3), "\xfe\xff\xc3");
  EXPECT_EQ(get_little_endian<std::int16_t>(bytes.data()), -2);
  EXPECT_EQ(get_little_endian<float>(bytes.data() + 5), 1.0F);
}

TEST(Result, AnErrorSaysWhatWhereAndHowToFix) {
  const Result<int> result = Error{.what = "truncated", .where = "a.mcap: chunk 3", .fix = "repair it"};
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(to_string(result.error()), "a.mcap: chunk 3: truncated. fix: repair it");
}

TEST(ResultDeathTest, TheValueOfAnErrorIsOurBug) {
  const Result<int> result = Error{.what = "no", .where = "here", .fix = ""};
  EXPECT_DEATH((void)result.value(), "telepalp bug");
}

TEST(Transform, NeighbouringFramesCancel) {
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  haptic_from_camera.iso = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  const Point<DepthCamera> at{{0.1, 0.2, 0.9}};
  EXPECT_LT((((haptic_from_camera.inverse() * haptic_from_camera) * at).m - at.m).norm(), 1e-15);
}

TEST(RgbdFrame, SizesThatDisagreeAreNotWellFormed) {
  DepthImage depth{.width = 2, .height = 2, .unit_m = 0.001, .samples = {1, 2, 3}};
  EXPECT_FALSE(is_well_formed(depth));
  depth.samples.push_back(4);
  EXPECT_TRUE(is_well_formed(depth));
  depth.unit_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_well_formed(depth));
}

TEST(LatestValue, TheConsumerSeesOnlyNewerValuesAndEndsOnTheLast) {
  LatestValue<int> slot;
  constexpr int kLast = 200'000;
  std::thread producer([&] {
    for (int value = 1; value <= kLast; ++value) slot.put(value);
  });
  int seen = 0;
  while (seen < kLast) {
    if (!slot.take()) continue;
    ASSERT_GT(slot.current(), seen);
    seen = slot.current();
  }
  producer.join();
}

TEST(SpscRing, KeepsAllInOrderAndSaysWhenItIsFull) {
  SpscRing<int, 4> ring;
  for (int value = 0; value < 4; ++value) EXPECT_TRUE(ring.try_push(value));
  EXPECT_FALSE(ring.try_push(4));
  int value = -1;
  for (int expected = 0; expected < 4; ++expected) {
    ASSERT_TRUE(ring.try_pop(value));
    EXPECT_EQ(value, expected);
  }
  EXPECT_FALSE(ring.try_pop(value));
}

TEST(SpscRing, AcrossTwoThreadsNothingIsLostOrTorn) {
  SpscRing<std::uint64_t, 64> ring;
  constexpr std::uint64_t kCount = 200'000;
  std::thread producer([&] {
    for (std::uint64_t value = 0; value < kCount;)
      if (ring.try_push(value)) ++value;
  });
  std::uint64_t value = 0;
  for (std::uint64_t expected = 0; expected < kCount;) {
    if (!ring.try_pop(value)) continue;
    ASSERT_EQ(value, expected);
    ++expected;
  }
  producer.join();
}

TEST(RotationVector, TurnsAboutItsAxisByItsLengthAndThenTranslates) {
  const Eigen::Isometry3d isometry = isometry_of({0.0, 0.0, std::numbers::pi / 2.0}, {1.0, 2.0, 3.0});
  EXPECT_LT((isometry * Eigen::Vector3d(1.0, 0.0, 0.0) - Eigen::Vector3d(1.0, 3.0, 3.0)).norm(), 1e-15);
  EXPECT_TRUE(isometry_of(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()).isApprox(Eigen::Isometry3d::Identity()));
}

TEST(SmoothStep, RisesFromZeroToOneWithoutSlopeAtItsEnds) {
  for (const double t : {-5.0, 0.0}) EXPECT_EQ(smooth_step(t), 0.0);
  for (const double t : {1.0, 5.0}) EXPECT_EQ(smooth_step(t), 1.0);
  EXPECT_EQ(smooth_step(0.5), 0.5);
  EXPECT_LT(smooth_step(1e-3), 4e-6);
  EXPECT_GT(smooth_step(1.0 - 1e-3), 1.0 - 4e-6);
  EXPECT_EQ(smooth_step(3.0, 1.0, 2.0), 0.5);  // falling
}

}  // namespace
}  // namespace telepalp
