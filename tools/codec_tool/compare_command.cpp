#include <cstdio>
#include <vector>

#include "proto/words/counted.h"
#include "tools/codec_tool/commands.h"
#include "tools/codec_tool/depth_difference.h"
#include "tools/codec_tool/depth_files.h"

namespace telepalp::codec_tool {
Result<void> compare_recordings(const std::filesystem::path& first, const std::filesystem::path& second, double unit_m,
                                const std::optional<DepthErrorBound>& bound) {
  std::vector<std::string> frames;  // compressed, because ten minutes of raw images do not fit into memory
  const Result<void> read = for_each_depth(first, unit_m, [&](const NamedDepth& named) -> Result<void> {
    frames.push_back(codec::encode_depth(named.depth, codec::DepthMode::Fast));
    return {};
  });
  if (!read) return read;
  std::size_t at = 0;
  DepthDifference difference(bound);
  const Result<void> done = for_each_depth(second, unit_m, [&](const NamedDepth& named) -> Result<void> {
    const std::string where = second.string() + ", frame " + std::to_string(at) + " (counted from 0)";
    if (at == frames.size())
      return Error{.what = "the first input has only " + counted(frames.size(), "frame", "frames"),
                   .where = where,
                   .fix = "give two inputs that hold the same recording"};
    const Result<DepthImage> other = codec::decode_depth(std::as_bytes(std::span(frames[at++])));
    if (!other) return other.error();
    if (other->width != named.depth.width || other->height != named.depth.height)
      return Error{.what = "the width or height differs from that of the same frame of the first input",
                   .where = where,
                   .fix = "give two inputs that hold the same recording"};
    difference.add(*other, named.depth);
    return {};
  });
  if (!done) return done;
  if (at != frames.size())
    return Error{
        .what = "has " + counted(at, "frame", "frames") + ", but the first input has " + std::to_string(frames.size()),
        .where = second.string(),
        .fix = "give two inputs that hold the same recording"};
  std::printf("%s: largest difference %.3f mm, RMS %.3f mm, %s measured in one input only\n",
              counted(at, "frame", "frames").c_str(), difference.worst_mm(), difference.rms_mm(),
              counted(difference.flips(), "pixel", "pixels").c_str());
  if (!bound) return {};
  if (difference.beyond() > 0)
    return Error{.what = counted(difference.beyond(), "pixel differs", "pixels differ") +
                         " from the first input by more than --bound allows, the first in " + difference.first_beyond(),
                 .where = second.string(),
                 .fix = "give a larger --bound, or encode the first input again with the same --bound"};
  std::printf("no pixel of the second input differs from the first input by more than --bound allows\n");
  return {};
}

}  // namespace telepalp::codec_tool
