#include "codec/depth_stream.h"

#include <gtest/gtest.h>

#include "tests/codec/depth_frames.h"

namespace telepalp::codec {
namespace {

DepthImage frame(unsigned number) { return kinect_like(96, 80, number, static_cast<int>(number)); }

std::vector<std::string> stream_of(DepthMode mode, unsigned frames, int key_every) {
  DepthEncoder encoder({.mode = mode, .key_every = key_every});
  std::vector<std::string> packets;
  for (unsigned i = 0; i < frames; ++i) packets.push_back(encoder.encode(frame(i)).bytes);
  return packets;
}

TEST(DepthReader, ReadsAnyFrameAfterSkippedOnes) {
  for (const DepthMode mode : {DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal}) {
    const std::vector<std::string> packets = stream_of(mode, 12, 5);
    for (unsigned wanted = 0; wanted < 12; ++wanted) {
      DepthReader reader;
      for (unsigned i = 0; i < wanted; ++i) reader.skip(packets[i]);
      const Result<DecodedDepth> back = reader.read(bytes_of(packets[wanted]));
      ASSERT_TRUE(back.ok()) << name(mode) << " " << wanted << ": " << to_string(back.error());
      EXPECT_EQ(back->image.samples, frame(wanted).samples);
    }
  }
}

TEST(DepthReader, ReadsOnAfterReadAndSkippedFrames) {
  const std::vector<std::string> packets = stream_of(DepthMode::Temporal, 20, 9);
  DepthReader reader;
  for (unsigned i = 0; i < packets.size(); ++i) {
    if (i % 3 != 0) {
      reader.skip(packets[i]);
      continue;
    }
    const Result<DecodedDepth> back = reader.read(bytes_of(packets[i]));
    ASSERT_TRUE(back.ok()) << i;
    EXPECT_EQ(back->image.samples, frame(i).samples);
  }
}

TEST(DepthReader, KeepsItsPlaceInAGroupLongerThanItKeepsPackets) {
  const std::vector<std::string> packets = stream_of(DepthMode::Temporal, 80, 1000);
  DepthReader reader;
  for (unsigned i = 0; i + 1 < packets.size(); ++i) reader.skip(packets[i]);
  const Result<DecodedDepth> back = reader.read(bytes_of(packets.back()));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->image.samples, frame(79).samples);
}

TEST(DepthReader, DamageInASkippedFrameIsAnErrorUntilTheNextKeyFrame) {
  std::vector<std::string> packets = stream_of(DepthMode::Temporal, 10, 6);
  char& byte = packets[3][packets[3].size() / 2];
  byte = static_cast<char>(byte ^ 1);
  DepthReader reader;
  for (unsigned i = 0; i < 4; ++i) reader.skip(packets[i]);
  EXPECT_FALSE(reader.read(bytes_of(packets[4])).ok());
  EXPECT_FALSE(reader.read(bytes_of(packets[5])).ok());
  const Result<DecodedDepth> key = reader.read(bytes_of(packets[6]));
  ASSERT_TRUE(key.ok());
  EXPECT_EQ(key->image.samples, frame(6).samples);
}

}  // namespace
}  // namespace telepalp::codec
