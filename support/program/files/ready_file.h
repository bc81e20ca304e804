#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::program {

/// Writes the lines `key=value` of `text` to `file` atomically: a script that waits until this program is ready never
/// reads a partial file. If `file` is empty, nothing is written.
[[nodiscard]] Result<void> write_ready_file(const std::filesystem::path& file, const std::string& text);

}  // namespace telepalp::program
