#include "support/images/image_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <random>

#include "proto/words/little_endian.h"
#include "server/capture/images/camera_file.h"
#include "server/capture/images/image_listing.h"
#include "where.h"

namespace telepalp::capture {
namespace {

namespace fs = std::filesystem;

const std::string kData = TELEPALP_SOURCE_DIR "/tests/data";

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span{text}); }

std::string file_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

images::GrayImage16 ramp(int width, int height) {
  images::GrayImage16 image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.samples.push_back(static_cast<std::uint16_t>(i * 257));
  return image;
}

TEST(Png, KeepsDepthSamplesExactly) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 5}, std::pair{640, 480}}) {
    const images::GrayImage16 image = ramp(width, height);
    const auto read = images::decode_png(bytes_of(images::encode_png(image)), "ramp.png");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    const auto* back = std::get_if<images::GrayImage16>(&*read);
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->width, width);
    EXPECT_EQ(back->samples, image.samples);
  }
}

TEST(Png, KeepsColourExactly) {
  const ColorImage image{2, 2, {1, 2, 3, 4, 5, 6, 250, 251, 252, 253, 254, 255}};
  const auto read = images::decode_png(bytes_of(images::encode_png(image)), "colour.png");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(std::get<ColorImage>(*read).rgb, image.rgb);
}

TEST(ImageFile, ReadsRealDepthAndColourOfBothFormats) {
  const auto png = images::read_depth_image(kData + "/images_rgb_depth/depth/40.png");
  ASSERT_TRUE(png.ok()) << to_string(png.error());
  EXPECT_EQ(png->width, 640);
  const auto color = images::read_color_image(kData + "/images_rgb_depth/rgb/40.png");
  ASSERT_TRUE(color.ok()) << to_string(color.error());
  EXPECT_TRUE(is_well_formed(*color));
  const auto tiff = images::read_depth_image(kData + "/images_tiff_pairs/frame_20121214T142255.814212_depth.tiff");
  ASSERT_TRUE(tiff.ok()) << to_string(tiff.error());
  EXPECT_EQ(tiff->height, 480);
  EXPECT_GT(*std::max_element(tiff->samples.begin(), tiff->samples.end()), 1500);
  EXPECT_LT(*std::max_element(tiff->samples.begin(), tiff->samples.end()), 2000);
  const auto picture = images::read_color_image(kData + "/images_tiff_pairs/frame_20121214T142255.814212_rgb.tiff");
  ASSERT_TRUE(picture.ok()) << to_string(picture.error());
  EXPECT_TRUE(is_well_formed(*picture));
}

TEST(ImageFile, SaysWhichKindItFoundInsteadOfTheOneAsked) {
  const auto depth = images::read_depth_image(kData + "/images_rgb_depth/rgb/40.png");
  ASSERT_FALSE(depth.ok());
  EXPECT_NE(depth.error().what.find("image"), std::string::npos);
  EXPECT_FALSE(images::read_color_image(kData + "/images_rgb_depth/depth/40.png").ok());
  EXPECT_FALSE(images::read_image(kData + "/ATTRIBUTION.md").ok());
  EXPECT_FALSE(images::read_image(kData + "/no_such.png").ok());
}

TEST(ImageFile, ATruncatedImageIsAnErrorNeverHalfAnImage) {
  const std::string png = file_bytes(kData + "/images_depth_only/30.png");
  const std::string tiff = file_bytes(kData + "/images_tiff_pairs/frame_20121214T142255.814212_depth.tiff");
  for (int eighth = 0; eighth < 8; ++eighth) {
    const auto part = [eighth](const std::string& whole) {
      return whole.substr(0, whole.size() * static_cast<std::size_t>(eighth) / 8);
    };
    EXPECT_FALSE(images::decode_png(bytes_of(part(png)), "cut.png").ok()) << eighth;
    EXPECT_FALSE(images::decode_tiff(bytes_of(part(tiff)), "cut.tiff").ok()) << eighth;
  }
}

TEST(ImageFile, FlippedBytesNeverCrashAndAPngNeverPassesThem) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random{kSeed};
  const std::string png = images::encode_png(ramp(40, 30));
  const std::string tiff = file_bytes(kData + "/images_tiff_pairs/frame_20121214T142255.814212_rgb.tiff");
  for (int i = 0; i < 300; ++i) {
    std::string damaged = png;
    damaged[random() % damaged.size()] ^= static_cast<char>(1 + random() % 255);
    const auto read = images::decode_png(bytes_of(damaged), "flipped.png");
    if (read.ok()) {
      EXPECT_EQ(std::get<images::GrayImage16>(*read).samples, ramp(40, 30).samples)
          << "seed " << kSeed << " step " << i;
    }
  }
  for (int i = 0; i < 60; ++i) {
    std::string damaged = tiff;
    // The directory of a TIFF determines how the rest is read, so damage there is the most dangerous.
    const std::size_t reach = i % 2 == 0 ? 400 : damaged.size();
    damaged[damaged.size() - 1 - random() % reach] ^= static_cast<char>(1 + random() % 255);
    damaged[random() % 8] ^= static_cast<char>(i % 3 == 0 ? 1 : 0);
    (void)images::decode_tiff(bytes_of(damaged), "flipped.tiff");
  }
}

TEST(Png, AClaimedGiantIsRefusedBeforeAnythingIsAllocated) {
  std::string png = images::encode_png(ramp(2, 2));
  const unsigned char giant[] = {0, 0, 0x40, 0, 0, 0, 0x40, 0};  // 16384 x 16384, in IHDR
  std::copy(std::begin(giant), std::end(giant), png.begin() + 16);
  EXPECT_FALSE(images::decode_png(bytes_of(png), "giant.png").ok());
}

void append_chunk(std::string& png, const std::string& kind, const std::string& data) {
  const auto big_endian = [&png](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) png += static_cast<char>(value >> shift & 255U);
  };
  big_endian(static_cast<std::uint32_t>(data.size()));
  const std::string body = kind + data;
  png += body;
  big_endian(static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
}

/// A PNG of 8 x 4 depth samples whose compressed data holds `extra` bytes more than its rows.
std::string png_with_extra(std::size_t extra, bool interlaced) {
  const std::size_t rows_bytes = interlaced ? 8 + 64 : 4 * (1 + 16);  // a filter byte leads each row of each pass
  const std::string raw(rows_bytes + extra, '\0');
  uLongf size = compressBound(raw.size());
  std::string data(size, '\0');
  compress2(reinterpret_cast<Bytef*>(data.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size(), 1);
  data.resize(size);
  std::string png = "\x89PNG\r\n\x1a\n";
  append_chunk(png, "IHDR", std::string({0, 0, 0, 8, 0, 0, 0, 4, 16, 0, 0, 0, static_cast<char>(interlaced)}));
  append_chunk(png, "IDAT", data);
  append_chunk(png, "IEND", "");
  return png;
}

TEST(Png, DataBehindTheLastRowIsRefusedWithoutReadingItAll) {
  constexpr std::size_t kBomb = 40U << 20U;
  EXPECT_TRUE(images::decode_png(bytes_of(png_with_extra(0, false)), "whole.png").ok());
  EXPECT_TRUE(images::decode_png(bytes_of(png_with_extra(0, true)), "whole.png").ok());
  EXPECT_FALSE(images::decode_png(bytes_of(png_with_extra(10, false)), "extra.png").ok());
  for (const bool interlaced : {false, true}) {
    const auto read = images::decode_png(bytes_of(png_with_extra(kBomb, interlaced)), "bomb.png");
    ASSERT_FALSE(read.ok());
    // If libpng reads everything, its error is "Too much image data".
    EXPECT_NE(read.error().what.find("more data than the rows"), std::string::npos) << to_string(read.error());
  }
}

TEST(Tiff, ThousandsOfChannelsAreRefusedBeforeAnythingIsAllocated) {
  std::string tiff("II*\0\x08\0\0\0", 8);
  const std::uint32_t tags[][2] = {{256, 4096}, {257, 4096},  {258, 8},    {259, 1}, {262, 1},
                                   {273, 8},    {277, 60000}, {278, 4096}, {279, 16}};
  append_little_endian<std::uint16_t>(tiff, std::size(tags));
  for (const auto& [tag, value] : tags) {
    append_little_endian<std::uint16_t>(tiff, static_cast<std::uint16_t>(tag));
    append_little_endian<std::uint16_t>(tiff, 4);  // of 32 bits
    append_little_endian<std::uint32_t>(tiff, 1);
    append_little_endian<std::uint32_t>(tiff, value);
  }
  append_little_endian<std::uint32_t>(tiff, 0);
  const auto read = images::decode_tiff(bytes_of(tiff), "channels.tiff");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().what.find("60000 channels"), std::string::npos) << to_string(read.error());
}

std::vector<fs::path> paths(std::initializer_list<const char*> names) { return {names.begin(), names.end()}; }

TEST(ImageListing, OrdersByNumberNotByName) {
  const auto pairs = order_images(paths({"10.png", "9.png", "8.png", "readme.txt"}), "dir");
  ASSERT_TRUE(pairs.ok()) << to_string(pairs.error());
  ASSERT_EQ(pairs->size(), 3u);
  EXPECT_EQ(pairs->front().depth, "8.png");
  EXPECT_EQ(pairs->back().depth, "10.png");
  EXPECT_FALSE(pairs->front().color);
}

TEST(ImageListing, PairsFoldersAndNamesSideBySide) {
  const auto folders = order_images(paths({"depth/1.png", "depth/2.png", "rgb/2.png", "rgb/1.png"}), "dir");
  ASSERT_TRUE(folders.ok()) << to_string(folders.error());
  EXPECT_EQ(folders->at(1).color, "rgb/2.png");
  const auto beside = order_images(paths({"depth_001.png", "color_001.png"}), "dir");
  ASSERT_TRUE(beside.ok()) << to_string(beside.error());
  EXPECT_EQ(beside->at(0).color, "color_001.png");
  const auto pcl = order_images(paths({"frame_20121214T142256.068683_depth.tiff",
                                       "frame_20121214T142256.068683_rgb.tiff", "frame_20121214T142255.814212_rgb.tiff",
                                       "frame_20121214T142255.814212.xml", "frame_20121214T142255.814212_depth.tiff"}),
                                "dir");
  ASSERT_TRUE(pcl.ok()) << to_string(pcl.error());
  EXPECT_EQ(pcl->at(0).color, "frame_20121214T142255.814212_rgb.tiff");
}

TEST(ImageListing, FoldersForDepthAndColourPairByNumberWhereTheFileNamesDiffer) {
  for (const auto& files :
       {paths({"depth/depth_0001.png", "depth/depth_0002.png", "rgb/rgb_0001.png", "rgb/rgb_0002.png"}),
        paths({"depth/frame1-depth.png", "depth/frame2-depth.png", "colour/frame1-colour.png",
               "colour/frame2-colour.png"}),
        paths({"depth/d-1.png", "depth/d-2.png", "rgb/c-1.png", "rgb/c-2.png"}),
        paths({"depth/1.png", "depth/2.png", "rgb/0001.jpg", "rgb/0002.jpg"}),
        paths({"1.png", "2.png", "rgb/1.png", "rgb/2.png"}), paths({"1.png", "2.png", "1.jpg", "2.jpg"})}) {
    const auto pairs = order_images(files, "dir");
    ASSERT_TRUE(pairs.ok()) << files.front() << ": " << to_string(pairs.error());
    ASSERT_EQ(pairs->size(), 2u) << files.front();
    EXPECT_EQ(pairs->at(0).depth, files.at(0));
    EXPECT_EQ(pairs->at(0).color, files.at(2));
    EXPECT_EQ(pairs->at(1).color, files.at(3));
  }
}

TEST(ImageListing, NumbersThatOutgrowTheirLeadingZerosAreInOrder) {
  const auto pairs = order_images(paths({"08.png", "09.png", "10.png", "99.png", "100.png"}), "dir");
  EXPECT_FALSE(pairs.ok()) << "11 to 98 are missing";
  EXPECT_TRUE(order_images(paths({"098.png", "099.png", "100.png"}), "dir").ok());
  EXPECT_TRUE(order_images(paths({"98.png", "99.png", "100.png"}), "dir").ok());
  EXPECT_TRUE(order_images(paths({"0099.png", "0098.png", "0100.png"}), "dir").ok());
}

TEST(ImageListing, EvenStepsAreNoGap) { EXPECT_TRUE(order_images(paths({"30.png", "50.png", "70.png"}), "dir").ok()); }

struct BadListing {
  const char* name;
  std::initializer_list<const char*> files;
  const char* says;
};
TEST(ImageListing, NamesWhatIsMissingOrTwice) {
  const BadListing kBad[] = {
      {"a gap", {"1.png", "2.png", "4.png"}, "3.png is missing between 2.png and 4.png"},
      {"a number twice", {"1.png", "2.png", "2.tiff"}, "2.png and 2.tiff have the same number"},
      {"nothing", {"notes.txt"}, "no depth images"},
      {"colour alone", {"rgb/1.png"}, "no depth images"},
      {"a colour missing",
       {"depth/1.png", "depth/2.png", "rgb/1.png"},
       "depth/2.png has no colour image of its name or number, such as rgb/1.png has"},
      {"a number without its leading zeros", {"0004.png", "5.png", "0006.png"}, "5.png has fewer digits than 0004.png"},
      {"the same of a colour image",
       {"depth/0004.png", "depth/0005.png", "rgb/0004.png", "rgb/5.png"},
       "rgb/5.png has fewer digits than rgb/0004.png"},
      {"a gap among padded numbers", {"0008.png", "0009.png", "0011.png"}, "0010.png is missing between"},
      {"a JPEG where depth should be", {"1.jpg", "2.jpg"}, "no depth images"},
  };
  for (const BadListing& bad : kBad) {
    const auto listed = order_images(paths(bad.files), "dir");
    ASSERT_FALSE(listed.ok()) << bad.name;
    EXPECT_NE(listed.error().what.find(bad.says), std::string::npos) << bad.name << ": " << listed.error().what;
    EXPECT_EQ(listed.error().where, "dir");
    EXPECT_FALSE(listed.error().fix.empty());
  }
}

/// A camera file in a temporary folder.
class CameraFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  Result<RecordedCamera> read(const std::string& text) {
    std::ofstream(folder_ / "camera.textproto") << text;
    return read_camera_file(folder_ / "camera.textproto", 640, 480);
  }
  fs::path folder_ =
      fs::temp_directory_path() /
      ("telepalp_camera_file_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

const std::string kGood =
    "depth { width: 640 height: 480 fx: 500 fy: 501 cx: 320 cy: 240 }\ncolor_registered: true\ndepth_unit_m: 0.001\n";

TEST_F(CameraFile, IsReadWithItsDefaults) {
  const auto camera = read(kGood);
  ASSERT_TRUE(camera.ok()) << to_string(camera.error());
  EXPECT_EQ(camera->model.depth.fy, 501);
  EXPECT_EQ(camera->model.color.fx, 500);
  EXPECT_EQ(camera->frames_per_s, 30);
  EXPECT_EQ(camera->ignore_above, 65535);
  EXPECT_TRUE(camera->warning.empty());
}

TEST_F(CameraFile, WhatTheWarningSaysToWriteCanBeRead) {
  const RecordedCamera assumed = assumed_camera(folder_ / "camera.textproto", 640, 480);
  const std::string marker = "assumed now: ";
  const std::size_t at = assumed.warning.find(marker);
  ASSERT_NE(at, std::string::npos) << assumed.warning;
  const auto camera = read(assumed.warning.substr(at + marker.size()));
  ASSERT_TRUE(camera.ok()) << to_string(camera.error());
  EXPECT_EQ(camera->model.depth.fx, assumed.model.depth.fx);
  EXPECT_EQ(camera->depth_unit_m, assumed.depth_unit_m);
  EXPECT_EQ(camera->ignore_above, assumed.ignore_above);
}

TEST_F(CameraFile, EachMistakeIsNamed) {
  const std::pair<std::string, std::string> kBad[] = {
      {"depth {\n  width: 640 height: 480 fx_px: 500\n}", ":2:"},
      {"depth { width: 640 height: 480 }\ndepth_unit_m: 0.001", "no usable camera intrinsics"},
      {"depth { width: 320 height: 240 fx: 250 fy: 250 }\ndepth_unit_m: 0.001", "320 x 240"},
      {"depth { width: 640 height: 480 fx: 500 fy: 500 }", "depth_unit_m"},
      {"depth { width: 640 height: 480 fx: 500 fy: 500 }\ndepth_unit_m: 1", "depth_unit_m"},
      {"depth { width: 640 height: 480 fx: nan fy: 500 }\ndepth_unit_m: 0.001", "no usable camera intrinsics"},
      {kGood + "frames_per_s: -3", "frames_per_s"},
      {kGood + "ignore_above: 70000", "ignore_above"},
  };
  for (const auto& [text, says] : kBad) {
    const auto camera = read(text);
    ASSERT_FALSE(camera.ok()) << text;
    EXPECT_NE(to_string(camera.error()).find(says), std::string::npos) << to_string(camera.error());
    EXPECT_NE(to_string(camera.error()).find("camera.textproto"), std::string::npos);
  }
}

}  // namespace
}  // namespace telepalp::capture
