#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::record {

/// What a session file holds, for people: length, size, what made it, how exact its depth is, and by topic how many
/// messages at what rate. Reads the file's index, and at most one image.
[[nodiscard]] Result<std::string> inspect(const std::filesystem::path& file);

}  // namespace telepalp::record
