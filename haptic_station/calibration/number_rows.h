#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::calibration {

/// Reads the text of a measurement file. Error: the file cannot be read, or is larger than 16 MiB.
[[nodiscard]] Result<std::string> read_rows(const std::filesystem::path& file);

}  // namespace telepalp::calibration
