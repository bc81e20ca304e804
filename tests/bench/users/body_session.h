#pragma once

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::bench {

/// Writes a session of depth images without colour: `seconds` of the body that the bill of a scene looks at, so that a
/// real server can serve to a real station what the bill is made of.
[[nodiscard]] Result<void> write_body_session(const std::filesystem::path& file, double seconds);

}  // namespace telepalp::bench
