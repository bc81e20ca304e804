#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "server/codec_tool/commands.h"
#include "server/codec_tool/depth_files.h"

namespace telepalp::server {
namespace {

/// How far apart images lie, over all pixels so far that both measured.
struct Difference {
  std::size_t measured = 0;
  std::size_t flips = 0;  ///< pixels that only one of the two measured
  double worst_mm = 0.0;
  double squares_mm2 = 0.0;

  /// `a` and `b` are of one size.
  void add(const DepthImage& a, const DepthImage& b) {
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
      if ((a.samples[i] == 0) != (b.samples[i] == 0)) ++flips;
      if (a.samples[i] == 0 || b.samples[i] == 0) continue;
      const double error_mm = 1000.0 * std::abs(a.samples[i] * a.unit_m - b.samples[i] * b.unit_m);
      worst_mm = std::max(worst_mm, error_mm);
      squares_mm2 += error_mm * error_mm;
      ++measured;
    }
  }
  [[nodiscard]] double rms_mm() const {
    return measured == 0 ? 0.0 : std::sqrt(squares_mm2 / static_cast<double>(measured));
  }
};

}  // namespace

Result<void> compare_recordings(const std::filesystem::path& first, const std::filesystem::path& second,
                                double unit_m) {
  std::vector<std::string> frames;  // compressed: ten minutes of them as they are would not fit into memory
  const Result<void> read = for_each_depth(first, unit_m, [&](const NamedDepth& named) -> Result<void> {
    frames.push_back(codec::encode_depth(named.depth, codec::DepthMode::Fast));
    return {};
  });
  if (!read) return read;
  std::size_t at = 0;
  Difference difference;
  const Result<void> done = for_each_depth(second, unit_m, [&](const NamedDepth& named) -> Result<void> {
    const std::string where = second.string() + " frame " + std::to_string(at);
    if (at == frames.size())
      return Error{.what = "has more frames than the first", .where = where, .fix = "give two inputs of one recording"};
    const Result<DepthImage> other = codec::decode_depth(std::as_bytes(std::span(frames[at++])));
    if (!other) return other.error();
    if (other->width != named.depth.width || other->height != named.depth.height)
      return Error{.what = "is of another size", .where = where, .fix = "give two inputs of one recording"};
    difference.add(*other, named.depth);
    return {};
  });
  if (!done) return done;
  if (at != frames.size())
    return Error{.what = "has " + std::to_string(at) + " frames, the first " + std::to_string(frames.size()),
                 .where = second.string(),
                 .fix = "give two inputs of one recording"};
  std::printf("%zu frames: max error %.3f mm, RMS %.3f mm, %zu validity flips\n", at, difference.worst_mm,
              difference.rms_mm(), difference.flips);
  return {};
}

}  // namespace telepalp::server
