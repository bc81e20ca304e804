#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/mcap/reading/stream_reader.h"
#include "proto/words/result.h"

namespace telepalp::record {

inline constexpr std::string_view kPartial = ".partial";  ///< ends the name of a session file while it is written

/// True if telepalp wrote the file: the metadata that `stream` has read hold the record "telepalp.session".
[[nodiscard]] bool is_of_telepalp(const wire::McapStreamReader& stream);

struct RepairReport {
  bool was_whole = false;                  ///< the file was intact; no copy was written
  std::filesystem::path file;              ///< the copy; the file itself if it was intact
  std::uint64_t messages = 0;              ///< number of recovered messages
  std::vector<std::string> damages;        ///< places that could not be read, in words
  std::optional<std::uint64_t> lost = {};  ///< messages that were in the file and are not recovered; nullopt: unknown
  bool only_end_is_missing = false;        ///< nothing is damaged, and the file ends where its writer was interrupted
};

/// Metadata record of a repaired copy: `from` (the original's name), `lost` (number of messages, "end": those that
/// an interrupted recorder did not write, or "unknown"), and `damage_0`, `damage_1`, …
inline constexpr std::string_view kRepairMetadata = "telepalp.repair";

/// Default name of the repaired copy: `session.repaired.mcap` for both `session.mcap` and `session.mcap.partial`.
[[nodiscard]] std::filesystem::path repaired_name(const std::filesystem::path& file);

/// Writes all readable messages of `file`, on any topic, with attachments and metadata to `out`, and an index. `file`
/// is not changed. Error: no message can be recovered, or `out` cannot be written.
[[nodiscard]] Result<RepairReport> repair(const std::filesystem::path& file, const std::filesystem::path& out);

/// What was recovered and what was lost, as text: "950 of 1000 messages; 50 are lost".
[[nodiscard]] std::string recovered(const RepairReport& report);

}  // namespace telepalp::record
