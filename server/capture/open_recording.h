#pragma once

#include <memory>
#include <string_view>

#include "server/capture/capture_source.h"

namespace telepalp::capture {

/// Opens a recording: oni:FILE, images:DIR, pcd:FILE or session:FILE.mcap. Needs no camera driver. Error: an unknown
/// kind of recording, or a file that cannot be read.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_recording(std::string_view spec,
                                                                    const SourceOptions& options);

}  // namespace telepalp::capture
