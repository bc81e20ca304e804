#pragma once

#include <filesystem>
#include <vector>

#include "clients/record/edit/cut.h"

namespace telepalp::record {

/// The most files that telepalp-record merges at once: memory holds, of each file, the chunks that are being read.
inline constexpr std::size_t kMostMerged = 256;

/// Writes the messages of all `files` to `out` in order of time, with all metadata and attachments. A message that is
/// in several files is written once. Stations of two servers may have equal sender numbers, so 1000 · k is added to
/// those of file k, counted from 0, if its server is not the first file's. Error: two files of different
/// servers both have depth images, or a file cannot be read or written.
[[nodiscard]] Result<EditReport> merge(const std::vector<std::filesystem::path>& files,
                                       const std::filesystem::path& out);

}  // namespace telepalp::record
