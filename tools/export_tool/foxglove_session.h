#pragma once

#include <cstdint>
#include <filesystem>

#include "proto/words/result.h"
#include "tools/export_tool/foxglove_messages.h"
#include "tools/export_tool/frames.h"

namespace telepalp::export_tool {

/// Writes the session `file` to the session file `out` in types that Foxglove, Lichtblick and plotting tools display
/// without an extension: colour and camera models as recorded; depth as an image and a coloured cloud; the station as
/// transforms, as a scene with the force as an arrow, and as recorded numbers; the layers inside the body as triangles;
/// ultrasound images. Returns the number of messages.
[[nodiscard]] Result<Exported> write_foxglove(const std::filesystem::path& file, const std::filesystem::path& out,
                                              const FoxgloveParts& parts = {});

}  // namespace telepalp::export_tool
