#include <gtest/gtest.h>

#include <filesystem>

#include "server/codec_tool/depth_files.h"
#include "server/codec_tool/pgm.h"

namespace telepalp::server {
namespace {

const GrayImage16 kImage{.width = 3, .height = 2, .samples = {0, 1, 255, 256, 700, 65535}};

TEST(Pgm, RoundTripKeepsEverySample) {
  const Result<GrayImage16> back = decode_pgm(encode_pgm(kImage), "a.pgm");
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(back->samples, kImage.samples);
  EXPECT_EQ(back->width, 3);
}

TEST(Pgm, ReadsCommentsAndRefusesWhatIsCutOffOrTooLarge) {
  const std::string pgm = encode_pgm(kImage);
  EXPECT_TRUE(decode_pgm("P5\n# by hand\n3 2\n# 16 bits\n65535\n" + pgm.substr(pgm.size() - 12), "a.pgm").ok());
  for (std::size_t size = 0; size < pgm.size(); ++size) EXPECT_FALSE(decode_pgm(pgm.substr(0, size), "a.pgm").ok());
  EXPECT_FALSE(decode_pgm("P5\n99999 99999\n65535\n", "a.pgm").ok());
  EXPECT_FALSE(decode_pgm("P5\n3 2\n255\n123456", "a.pgm").ok());
}

TEST(DepthFiles, GiveTheImagesOfADirectoryInOrderAndPassOverColour) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "telepalp_depth_files";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "depth");
  for (const std::uint16_t number : {std::uint16_t{2}, std::uint16_t{1}}) {
    GrayImage16 image = kImage;
    image.samples[0] = number;
    ASSERT_TRUE(write_file(folder / "depth" / (std::to_string(number) + ".png"), encode_png(image)).ok());
  }
  ASSERT_TRUE(write_file(folder / "picture.png", encode_png(ColorImage{2, 1, {1, 2, 3, 4, 5, 6}})).ok());
  std::vector<std::uint16_t> first_samples;
  const Result<void> done = for_each_depth(folder, 0.000125, [&](NamedDepth named) -> Result<void> {
    EXPECT_EQ(named.depth.unit_m, 0.000125);
    first_samples.push_back(named.depth.samples.front());
    return {};
  });
  EXPECT_TRUE(done.ok());
  EXPECT_EQ(first_samples, (std::vector<std::uint16_t>{1, 2}));
  EXPECT_FALSE(for_each_depth(folder / "none.png", 0.001, [](NamedDepth) -> Result<void> { return {}; }).ok());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace telepalp::server
