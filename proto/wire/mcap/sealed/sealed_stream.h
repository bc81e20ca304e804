#pragma once

#include <filesystem>
#include <istream>
#include <memory>
#include <ostream>

#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Makes an empty file for data that shows a patient and is no session, such as a station's journal: encrypted with
/// the first key of TELEPALP_SITE_KEYS, or plain if the variable is not set. Its owner and group may read it. Each
/// flush() writes what came since the last one, and a crash loses no more. The stream is bad after a failed write. An
/// existing file is emptied. Error: the file cannot be made, or the key cannot be read.
[[nodiscard]] Result<std::unique_ptr<std::ostream>> create_stream(const std::filesystem::path& file);

/// The bytes of such a file, decrypted if they are encrypted; they end before an altered block. Error: the file cannot
/// be opened, or its key is not given.
[[nodiscard]] Result<std::unique_ptr<std::istream>> open_stream(const std::filesystem::path& file);

}  // namespace telepalp::wire::mcap
