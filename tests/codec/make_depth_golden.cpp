// Writes the golden packets, each with its depth as plain PGM: make_depth_golden tests/codec/golden. Only a new version
// of the format may change the files.

#include <cstdio>
#include <fstream>

#include "codec/depth_stream.h"
#include "tests/codec/depth_frames.h"

namespace telepalp::codec {
namespace {

void write(const std::string& stem, const std::string& packet, const DepthImage& depth) {
  std::ofstream(stem + ".tpd", std::ios::binary) << packet;
  std::ofstream readable(stem + ".pgm");
  readable << "P2\n# unit_m " << depth.unit_m << "\n" << depth.width << ' ' << depth.height << "\n65535\n";
  for (std::size_t i = 0; i < depth.samples.size(); ++i)
    readable << depth.samples[i] << ((i + 1) % static_cast<std::size_t>(depth.width) == 0 ? '\n' : ' ');
}

void write_sequence(const std::string& folder, DepthMode mode) {
  DepthEncoder encoder({.mode = mode});
  DepthDecoder decoder;
  for (unsigned i = 0; i < 3; ++i) {
    const DepthImage depth = i == 2 ? noise(24, 18, 9) : kinect_like(24, 18, i, static_cast<int>(i));
    const std::string packet = encoder.encode(depth).bytes;
    write(folder + "/" + std::string(name(mode)) + "_" + std::to_string(i), packet, *decoder.decode(bytes_of(packet)));
  }
}

}  // namespace
}  // namespace telepalp::codec

int main(int argc, char** argv) {
  using telepalp::codec::DepthMode;
  if (argc != 2) {
    std::fprintf(stderr, "error: name the folder to write to\n");
    return 2;
  }
  for (const DepthMode mode : {DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal, DepthMode::Bounded})
    telepalp::codec::write_sequence(argv[1], mode);
  return 0;
}
