#include <utility>

#include "server/capture/pacing/recorded_source.h"
#include "server/capture/session/session_frames.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

Result<std::unique_ptr<CaptureSource>> open_session(const std::string& file, const SourceOptions& options) {
  Result<SessionFrames> frames = SessionFrames::open(file, options.keep_compressed);
  if (!frames) return frames.error();
  return play_recorded(std::make_unique<SessionFrames>(std::move(*frames)), "plays the recorded session " + file,
                       options);
}

}  // namespace telepalp::capture
