// Writes the golden packets, each with its depth as plain PGM: make_depth_golden tests/codec/golden. Only a new version
// of the format may change the files.

#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "codec/depth_stream.h"
#include "tests/codec/depth_frames.h"
#include "tests/codec/depth_windows.h"

namespace telepalp::codec {
namespace {

/// "# unit_m 0.001", and the window, if there is one: ", exact 6 4 10 8, near 0.002 0.0057, border 0.002 0.0057".
std::string comment_of(const DecodedDepth& depth) {
  std::ostringstream text;
  text << "# unit_m " << depth.image.unit_m;
  if (!depth.window) return text.str();
  const auto& [exact, near, border] = *depth.window;
  text << ", exact " << exact.column << ' ' << exact.row << ' ' << exact.width << ' ' << exact.height << ", near "
       << near.least_m << ' ' << near.per_m << ", border " << border.least_m << ' ' << border.per_m;
  return text.str();
}

void write(const std::string& stem, const std::string& packet, const DecodedDepth& depth) {
  std::ofstream(stem + ".tpd", std::ios::binary) << packet;
  std::ofstream readable(stem + ".pgm");
  const DepthImage& image = depth.image;
  readable << "P2\n" << comment_of(depth) << "\n" << image.width << ' ' << image.height << "\n65535\n";
  for (std::size_t i = 0; i < image.samples.size(); ++i)
    readable << image.samples[i] << ((i + 1) % static_cast<std::size_t>(image.width) == 0 ? '\n' : ' ');
}

void write_sequence(const std::string& stem, DepthMode mode, bool has_window) {
  DepthEncoder encoder({.mode = mode});
  DepthReader reader;
  for (unsigned i = 0; i < 3; ++i) {
    const auto window = has_window ? std::optional(golden_window(i)) : std::nullopt;
    const std::string packet = encoder.encode(golden_frame(i), window).bytes;
    write(stem + "_" + std::to_string(i), packet, *reader.read(bytes_of(packet)));
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
  const std::string folder = std::string(argv[1]) + "/";
  for (const DepthMode mode : {DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal, DepthMode::Bounded})
    telepalp::codec::write_sequence(folder + std::string(telepalp::codec::name(mode)), mode, false);
  for (const DepthMode mode : {DepthMode::Intra, DepthMode::Temporal})
    telepalp::codec::write_sequence(folder + "window_" + std::string(telepalp::codec::name(mode)), mode, true);
  return 0;
}
