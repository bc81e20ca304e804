#pragma once

#include <cstdint>
#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::export_tool {

/// Writes the session `file` to the session file `out` in Foxglove's own types, which its viewers display without an
/// extension: colour and camera models as recorded; depth as an image and a cloud; the station as transforms, and as a
/// scene with the force as an arrow; ultrasound images. Returns the number of messages.
[[nodiscard]] Result<std::uint64_t> write_foxglove(const std::filesystem::path& file, const std::filesystem::path& out);

}  // namespace telepalp::export_tool
