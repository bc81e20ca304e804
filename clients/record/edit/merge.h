#pragma once

#include <filesystem>
#include <vector>

#include "clients/record/edit/cut.h"

namespace telepalp::record {

/// At most this many files are merged at once: of each file, the chunks around the present time are in memory.
inline constexpr std::size_t kMostMerged = 256;

/// Writes the messages of all `files` to `out` in order of time, with all metadata and attachments. A message that is
/// in several files is written once. Stations of two servers may have equal sender numbers, so 1000 · k is added to
/// those of file k, counted from 0, if its server is not the first file's. Error: the first file and a file of
/// another server both have depth images, or a file cannot be read or written.
[[nodiscard]] Result<EditReport> merge(const std::vector<std::filesystem::path>& files,
                                       const std::filesystem::path& out);

}  // namespace telepalp::record
