#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>

#include "proto/words/demand.h"
#include "server/capture/oni/record_walk.h"
#include "server/capture/oni/recording.h"

using namespace telepalp;

/// An .oni recording: either an error that says what, where and how to fix it, or images that lie within the file; each
/// depth image decodes to whole rows or to an error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostDecoded = 4;
  std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
  const Result<capture::OniRecording> recording = capture::read_oni_recording(file, "fuzz");
  if (!recording) {
    const Error& error = recording.error();
    demand(!error.what.empty() && error.where.starts_with("fuzz") && !error.fix.empty(), "an error says all");
    return 0;
  }
  demand(!recording->depth.images.empty(), "a recording has depth");
  for (const capture::OniStream* stream : {&recording->depth, &recording->color})
    for (const capture::OniImage& image : stream->images)
      demand(image.at <= size && image.bytes <= size - image.at, "an image lies within the file");
  const std::size_t count = std::min(kMostDecoded, recording->depth.images.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto depth = capture::read_oni_depth(file, recording->depth, recording->depth.images[i], "fuzz");
    demand(!depth || is_well_formed(*depth), "a depth image has whole rows");
  }
  return 0;
}
