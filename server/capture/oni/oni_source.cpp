#include <utility>

#include "server/capture/oni/oni_frames.h"
#include "server/capture/pacing/recorded_source.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

Result<std::unique_ptr<CaptureSource>> open_oni(const std::string& file, const SourceOptions& options) {
  Result<std::unique_ptr<OniFrames>> frames = OniFrames::open(file);
  if (!frames) return frames.error();
  std::string description = (*frames)->describe();
  return play_recorded(std::move(*frames), std::move(description), options);
}

}  // namespace telepalp::capture
