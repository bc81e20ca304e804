#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::keys {

/// The SHA-256 of a file's content, in hexadecimal. The file is read block by block. Error: it cannot be read.
[[nodiscard]] Result<std::string> sha256_hex_of_file(const std::filesystem::path& file);

}  // namespace telepalp::keys
