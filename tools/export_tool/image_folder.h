#pragma once

#include <cstdint>
#include <filesystem>

#include "proto/words/result.h"
#include "tools/export_tool/frames.h"

namespace telepalp::export_tool {

/// Writes the frames of the session `file` to the folder `out`: depth/000001.png (16-bit samples), rgb/000001.png, and
/// camera.textproto, as telepalp-server --source images:DIR reads them. If the first frame has colour, frames without
/// colour are left out; if it has none, frames with colour are left out. Returns the number of frames. Error: `out`
/// exists and is not empty, or the session has no frame that can be decoded.
[[nodiscard]] Result<Exported> write_images(const std::filesystem::path& file, const std::filesystem::path& out);

}  // namespace telepalp::export_tool
