#pragma once

#include <memory>
#include <string>

#include "server/capture/capture_source.h"
#include "server/capture/pacing/recorded_frames.h"

namespace telepalp::server {

/// A recording as a camera: its frames at the pace at which they were captured, stamped with now's time. `description`
/// is for people.
[[nodiscard]] std::unique_ptr<CaptureSource> play_recorded(std::unique_ptr<RecordedFrames> frames,
                                                           std::string description, const SourceOptions& options);

}  // namespace telepalp::server
