#pragma once

#include <memory>
#include <string>

#include "server/capture/capture_source.h"
#include "server/capture/pacing/recorded_frames.h"

namespace telepalp::capture {

/// Plays a recording like a camera: at the recorded pace, with a pause of more than 2 s cut to 2 s. A frame's
/// `captured` is the session time at which the frame is due. `description`: text for the technician.
[[nodiscard]] std::unique_ptr<CaptureSource> play_recorded(std::unique_ptr<RecordedFrames> frames,
                                                           std::string description, const SourceOptions& options);

}  // namespace telepalp::capture
