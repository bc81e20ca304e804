#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::record {

struct RepairReport {
  bool was_whole = false;  ///< nothing was wrong with it, and nothing has been written
  std::filesystem::path file;
  std::uint64_t messages = 0;  ///< recovered
  std::vector<std::string> damages;
};

/// Where the repaired copy of `file` goes when nobody says: `session.mcap`, and `session.mcap.partial` too, become
/// `session.repaired.mcap`.
[[nodiscard]] std::filesystem::path repaired_name(const std::filesystem::path& file);

/// Writes to `out` every message of `file` that can be read, whatever its topic, with an index. `file` is not
/// changed. An error when nothing can be recovered.
[[nodiscard]] Result<RepairReport> repair(const std::filesystem::path& file, const std::filesystem::path& out);

}  // namespace telepalp::record
