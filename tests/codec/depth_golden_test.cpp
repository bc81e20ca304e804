#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "codec/depth_stream.h"
#include "tests/codec/depth_frames.h"
#include "where.h"

namespace telepalp::codec {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Samples of a plain PGM, its one comment skipped.
std::vector<std::uint16_t> read_plain_pgm(const std::string& path) {
  std::istringstream text(read(path));
  std::string line;
  for (int i = 0; i < 4; ++i) std::getline(text, line);
  return {std::istream_iterator<std::uint16_t>(text), {}};
}

class Golden : public testing::TestWithParam<DepthMode> {};

TEST_P(Golden, PacketsOfThisFormatDecodeAsTheyAlwaysDid) {
  DepthDecoder decoder;
  for (int i = 0; i < 3; ++i) {
    const std::string stem = std::string(TELEPALP_SOURCE_DIR) + "/tests/codec/golden/" + std::string(name(GetParam())) +
                             "_" + std::to_string(i);
    const Result<DepthImage> depth = decoder.decode(bytes_of(read(stem + ".tpd")));
    ASSERT_TRUE(depth.ok()) << stem << ": " << to_string(depth.error());
    EXPECT_EQ(depth->samples, read_plain_pgm(stem + ".pgm")) << stem;
  }
}

TEST_P(Golden, ThisEncoderStillWritesTheGoldenPackets) {
  DepthEncoder encoder({.mode = GetParam()});
  for (unsigned i = 0; i < 3; ++i) {
    const DepthImage depth = i == 2 ? noise(24, 18, 9) : kinect_like(24, 18, i, static_cast<int>(i));
    const std::string packet = encoder.encode(depth).bytes;
    if (GetParam() == DepthMode::Fast) continue;  // its bytes depend on the version of zstd
    EXPECT_EQ(packet, read(std::string(TELEPALP_SOURCE_DIR) + "/tests/codec/golden/" + std::string(name(GetParam())) +
                           "_" + std::to_string(i) + ".tpd"));
  }
}

std::string name_of(const testing::TestParamInfo<DepthMode>& tested) { return std::string(name(tested.param)); }

INSTANTIATE_TEST_SUITE_P(All, Golden,
                         testing::Values(DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal, DepthMode::Bounded),
                         name_of);

}  // namespace
}  // namespace telepalp::codec
