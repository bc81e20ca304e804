#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::program {

/// Writes `text`, lines of `key=value`, for whoever waits until this program is ready; in one step, so that no one
/// reads half of it. An empty `file` asks for nothing.
[[nodiscard]] Result<void> write_ready_file(const std::filesystem::path& file, const std::string& text);

}  // namespace telepalp::program
