#include <gtest/gtest.h>

#include <filesystem>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "proto/wire/mcap/writer.h"
#include "support/program/files/whole_file.h"
#include "tests/codec/depth_frames.h"
#include "tools/codec_tool/depth_files.h"
#include "tools/codec_tool/pgm.h"

namespace telepalp::server {
namespace {

const images::GrayImage16 kImage{.width = 3, .height = 2, .samples = {0, 1, 255, 256, 700, 65535}};

TEST(Pgm, RoundTripKeepsEverySample) {
  const Result<images::GrayImage16> back = codec_tool::decode_pgm(codec_tool::encode_pgm(kImage), "a.pgm");
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(back->samples, kImage.samples);
  EXPECT_EQ(back->width, 3);
}

TEST(Pgm, ReadsCommentsAndRefusesWhatIsCutOffOrTooLarge) {
  const std::string pgm = codec_tool::encode_pgm(kImage);
  EXPECT_TRUE(
      codec_tool::decode_pgm("P5\n# by hand\n3 2\n# 16 bits\n65535\n" + pgm.substr(pgm.size() - 12), "a.pgm").ok());
  for (std::size_t size = 0; size < pgm.size(); ++size)
    EXPECT_FALSE(codec_tool::decode_pgm(pgm.substr(0, size), "a.pgm").ok());
  EXPECT_FALSE(codec_tool::decode_pgm("P5\n99999 99999\n65535\n", "a.pgm").ok());
  EXPECT_FALSE(codec_tool::decode_pgm("P5\n3 2\n255\n123456", "a.pgm").ok());
}

TEST(DepthFiles, GiveTheImagesOfADirectoryInOrderAndPassOverColour) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "telepalp_depth_files";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "depth");
  for (const std::uint16_t number : {std::uint16_t{2}, std::uint16_t{1}}) {
    images::GrayImage16 image = kImage;
    image.samples[0] = number;
    ASSERT_TRUE(program::write_whole_file(folder / "depth" / (std::to_string(number) + ".png"),
                                          images::encode_png(image), program::Readers::Group)
                    .ok());
  }
  ASSERT_TRUE(program::write_whole_file(folder / "picture.png",
                                        images::encode_png(ColorImage{2, 1, {1, 2, 3, 4, 5, 6}}),
                                        program::Readers::Group)
                  .ok());
  std::vector<std::uint16_t> first_samples;
  const Result<void> done =
      codec_tool::for_each_depth(folder, 0.000125, [&](codec_tool::NamedDepth named) -> Result<void> {
        EXPECT_EQ(named.depth.unit_m, 0.000125);
        first_samples.push_back(named.depth.samples.front());
        return {};
      });
  EXPECT_TRUE(done.ok());
  EXPECT_EQ(first_samples, (std::vector<std::uint16_t>{1, 2}));
  EXPECT_FALSE(codec_tool::for_each_depth(folder / "none.png", 0.001, [](codec_tool::NamedDepth) -> Result<void> {
                 return {};
               }).ok());
  std::filesystem::remove_all(folder);
}

TEST(DepthFiles, OfARecordingThatLacksAFrameAllThatCanBeReadIsGiven) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "telepalp_lacking.mcap";
  std::filesystem::remove(file);
  auto writer = wire::McapWriter::open(file, {});
  ASSERT_TRUE(writer.ok());
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 4});
  for (unsigned i = 0; i < 8; ++i) {
    msg::DepthImage image;
    const codec::EncodedDepth encoded = encoder.encode(codec::kinect_like(32, 24, i));
    image.set_data(encoded.bytes);
    if (i == 1) continue;  // never recorded
    ASSERT_TRUE(
        writer->write(wire::make_message(wire::kCameraDepth, session_time(i + 1), image, encoded.key_frame)).ok());
  }
  ASSERT_TRUE(writer->close().ok());
  std::vector<std::vector<std::uint16_t>> read;
  const auto visit = [&](codec_tool::NamedDepth named) -> Result<void> {
    read.push_back(std::move(named.depth.samples));
    return {};
  };
  EXPECT_FALSE(codec_tool::for_each_depth(file, 0.001, visit).ok());
  read.clear();
  int unreadable = 0;
  EXPECT_TRUE(codec_tool::for_each_depth(file, 0.001, visit, [&](const Error&) { ++unreadable; }).ok());
  EXPECT_EQ(unreadable, 2);
  ASSERT_EQ(read.size(), 5u);
  EXPECT_EQ(read[0], codec::kinect_like(32, 24, 0).samples);
  EXPECT_EQ(read[1], codec::kinect_like(32, 24, 4).samples);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace telepalp::server
