#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::record {

struct RepairReport {
  bool was_whole = false;            ///< the file was intact; no copy was written
  std::filesystem::path file;        ///< the copy; the file itself if it was intact
  std::uint64_t messages = 0;        ///< number of recovered messages
  std::vector<std::string> damages;  ///< places that could not be read, in words
};

/// Default name of the repaired copy: `session.repaired.mcap` for both `session.mcap` and `session.mcap.partial`.
[[nodiscard]] std::filesystem::path repaired_name(const std::filesystem::path& file);

/// Writes all readable messages of `file`, on any topic, with attachments and metadata to `out`, and an index. `file`
/// is not changed. Error: no message can be recovered, or `out` cannot be written.
[[nodiscard]] Result<RepairReport> repair(const std::filesystem::path& file, const std::filesystem::path& out);

}  // namespace telepalp::record
