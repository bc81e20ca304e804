#pragma once

#include <memory>
#include <string>

#include "server/capture/capture_source.h"
#include "server/capture/pacing/recorded_frames.h"

namespace telepalp::capture {

/// Plays a recording like a camera: at the recorded pace, except that a pause of more than 2 s is cut to 2 s, and with
/// current time stamps. `description`: text for the technician.
[[nodiscard]] std::unique_ptr<CaptureSource> play_recorded(std::unique_ptr<RecordedFrames> frames,
                                                           std::string description, const SourceOptions& options);

}  // namespace telepalp::capture
