#include "tests/bench/depth/depth_set.h"

#include <chrono>
#include <cmath>
#include <sstream>

#include "codec/levels/level_palette.h"
#include "proto/words/numbers/quantile.h"
#include "server/capture/capture_source.h"
#include "tools/codec_tool/depth_files.h"

namespace telepalp::bench {
namespace {

constexpr std::size_t kSyntheticFrames = 20;
constexpr std::size_t kMostBytes = std::size_t{1} << 30U;  // of samples held in memory: 1700 frames of 640 x 480

}  // namespace

std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream text(list);
  for (std::string name; std::getline(text, name, ',');) names.push_back(name);
  return names;
}

Result<DepthSet> depth_set_of(const std::string& input) {
  DepthSet frames;
  std::size_t bytes = 0;
  if (!input.empty()) {
    const Result<void> read =
        codec_tool::for_each_depth(input, 0.001, [&](codec_tool::NamedDepth named) -> Result<void> {
          bytes += 2 * named.depth.samples.size();
          if (bytes <= kMostBytes)
            frames.images.push_back(std::move(named.depth));
          else
            ++frames.left_out;
          return {};
        });
    if (!read) return read.error();
  } else {
    auto source =
        capture::open_source("synthetic", {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = true, .paced = false});
    if (!source) return source.error();
    while (frames.images.size() < kSyntheticFrames)
      if (auto frame = (*source)->next(std::chrono::milliseconds{100}))
        frames.images.push_back(std::move(frame->depth));
  }
  if (frames.images.empty()) return Error{.what = "holds no depth image", .where = input, .fix = "give depth images"};
  return frames;
}

bool is_kinects(const DepthImage& frame) {
  constexpr double kStep_per_m = 2.85e-3;
  constexpr std::size_t kFewest = 16;
  std::vector<double> steps;
  const std::vector<std::uint16_t> levels = codec::palette_of(frame.samples).levels;
  for (std::size_t i = 2; i < levels.size(); ++i) {
    const double near_m = levels[i - 1] * frame.unit_m;
    const double far_m = levels[i] * frame.unit_m;
    if (near_m >= 1.0) steps.push_back((far_m - near_m) / (near_m * far_m));  // nearer levels are rounded too coarsely
  }
  if (steps.size() < kFewest) return false;
  return std::abs(median_of(steps) / kStep_per_m - 1.0) < 0.1;
}

double raw_bytes(const std::vector<DepthImage>& images) {
  double bytes = 0.0;
  for (const DepthImage& image : images) bytes += 2.0 * static_cast<double>(image.samples.size());
  return bytes;
}

}  // namespace telepalp::bench
