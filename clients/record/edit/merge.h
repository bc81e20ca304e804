#pragma once

#include <filesystem>
#include <vector>

#include "clients/record/edit/cut.h"

namespace telepalp::record {

/// At most this many files are merged at once: each keeps the chunks of one instant in memory.
inline constexpr std::size_t kMostMerged = 256;

/// Writes the messages of all `files` to `out` in order of time, with all metadata and attachments. A message that is
/// in several files is written once. Files of another server than the first keep their stations apart: 1000 · k is
/// added to the sender numbers of the k-th file. Error: cameras of two servers, or a file that cannot be read or
/// written.
[[nodiscard]] Result<EditReport> merge(const std::vector<std::filesystem::path>& files,
                                       const std::filesystem::path& out);

}  // namespace telepalp::record
