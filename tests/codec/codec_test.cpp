#include <gtest/gtest.h>

#include "codec/color.h"
#include "codec/depth.h"

namespace telepalp::codec {
namespace {

TEST(DepthCodec, RoundTripIsLossless) {
  DepthImage depth{.width = 3, .height = 2, .unit_m = 0.000125, .samples = {0, 1, 65535, 700, 701, 0}};
  const std::string packet = encode_depth(depth);
  const Result<DepthImage> back = decode_depth(std::as_bytes(std::span(packet)));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->samples, depth.samples);
  EXPECT_EQ(back->unit_m, depth.unit_m);
}

TEST(DepthCodec, EveryTruncationIsAnError) {
  const DepthImage depth{.width = 4, .height = 4, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(16, 700)};
  const std::string packet = encode_depth(depth);
  for (std::size_t size = 0; size < packet.size(); ++size)
    EXPECT_FALSE(decode_depth(std::as_bytes(std::span(packet).first(size))).ok()) << size;
}

/// A progressive JPEG of 8 x 8 grey pixels that codes the same picture in `scans` scans, without a mistake.
std::string picture_of_scans(int scans) {
  const std::vector<std::uint8_t> grey(64, 128);
  std::string jpeg = encode_gray(grey, 8, 8, 90);
  jpeg[jpeg.find("\xff\xc0") + 1] = '\xc2';  // start of a progressive frame
  const std::size_t scan = jpeg.find("\xff\xda");
  const std::string one = jpeg.substr(scan, 6) + std::string("\0\0\0\0\x3f", 5);  // mean alone, all bits; its value 0
  jpeg.resize(scan);
  for (int number = 0; number < scans; ++number) jpeg += one;
  return jpeg + "\xff\xd9";
}

TEST(ColorCodec, APictureOfThousandsOfScansIsRefused) {
  const auto decoded = [](int scans) {
    const std::string jpeg = picture_of_scans(scans);
    return decode_color(std::as_bytes(std::span(jpeg)));
  };
  const Result<ColorImage> few = decoded(3);
  EXPECT_TRUE(few.ok()) << (few ? "" : to_string(few.error()));
  const Result<ColorImage> many = decoded(5000);
  ASSERT_FALSE(many.ok());
  EXPECT_NE(to_string(many.error()).find("scans"), std::string::npos) << to_string(many.error());
}

TEST(ColorCodec, RoundTripLooksTheSameAndTruncationIsAnError) {
  ColorImage color{.width = 32, .height = 16, .rgb = std::vector<std::uint8_t>(32 * 16 * 3, 120)};
  const std::string jpeg = encode_color(color, 85);
  const Result<ColorImage> back = decode_color(std::as_bytes(std::span(jpeg)));
  ASSERT_TRUE(back.ok());
  ASSERT_EQ(back->rgb.size(), color.rgb.size());
  for (const std::uint8_t value : back->rgb) EXPECT_NEAR(value, 120, 2);
  for (std::size_t size = 0; size + 2 < jpeg.size(); ++size)
    EXPECT_FALSE(decode_color(std::as_bytes(std::span(jpeg).first(size))).ok()) << size;
}

}  // namespace
}  // namespace telepalp::codec
