#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

#include "codec/depth_stream.h"
#include "tests/codec/depth_frames.h"
#include "tests/codec/depth_windows.h"
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

/// A golden sequence: the mode, and whether its frames have windows.
struct Sequence {
  std::string name;
  DepthMode mode;
  bool has_window = false;

  [[nodiscard]] std::string stem(unsigned frame) const {
    return std::string(TELEPALP_SOURCE_DIR) + "/tests/codec/golden/" + name + "_" + std::to_string(frame);
  }
  [[nodiscard]] std::optional<DepthWindow> window(unsigned frame) const {
    return has_window ? std::optional(golden_window(frame)) : std::nullopt;
  }
};

class Golden : public testing::TestWithParam<Sequence> {};

TEST_P(Golden, PacketsOfThisFormatDecodeAsTheyAlwaysDid) {
  DepthReader reader;
  for (unsigned i = 0; i < 3; ++i) {
    const std::string stem = GetParam().stem(i);
    const Result<DecodedDepth> depth = reader.read(bytes_of(read(stem + ".tpd")));
    ASSERT_TRUE(depth.ok()) << stem << ": " << to_string(depth.error());
    EXPECT_EQ(depth->image.samples, read_plain_pgm(stem + ".pgm")) << stem;
    EXPECT_EQ(depth->window, GetParam().window(i)) << stem;
  }
}

TEST_P(Golden, ThisEncoderStillWritesTheGoldenPackets) {
  DepthEncoder encoder({.mode = GetParam().mode});
  for (unsigned i = 0; i < 3; ++i) {
    const std::string packet = encoder.encode(golden_frame(i), GetParam().window(i)).bytes;
    if (GetParam().mode == DepthMode::Fast) continue;  // its bytes depend on the version of zstd
    EXPECT_EQ(packet, read(GetParam().stem(i) + ".tpd"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Golden,
                         testing::Values(Sequence{"fast", DepthMode::Fast}, Sequence{"intra", DepthMode::Intra},
                                         Sequence{"temporal", DepthMode::Temporal},
                                         Sequence{"bounded", DepthMode::Bounded},
                                         Sequence{"window_intra", DepthMode::Intra, true},
                                         Sequence{"window_temporal", DepthMode::Temporal, true}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace telepalp::codec
