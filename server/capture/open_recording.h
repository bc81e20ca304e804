#pragma once

#include <memory>
#include <string_view>

#include "server/capture/capture_source.h"

namespace telepalp::server {

/// Opens a recording: oni:FILE, images:DIR, pcd:FILE or session:FILE.mcap. Errors as for open_source(). Needs no camera
/// driver.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_recording(std::string_view spec,
                                                                    const SourceOptions& options);

}  // namespace telepalp::server
