#pragma once

#include <filesystem>

#include "proto/wire/mcap/writer.h"
#include "proto/words/result.h"

namespace telepalp::record {

/// Reads a file as an attachment of a session. Error: it cannot be read, or is larger than 16 MiB.
[[nodiscard]] Result<wire::mcap::Attachment> attach(const std::filesystem::path& file);

}  // namespace telepalp::record
