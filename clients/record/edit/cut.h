#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "clients/record/selection/topic_filter.h"
#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::record {

struct CutOptions {
  Nanoseconds from{0};                 ///< since the session's first message
  std::optional<Nanoseconds> to = {};  ///< since the session's first message; nullopt: its end
  TopicFilter topics{"*"};
};

inline constexpr std::size_t kMostDamagesTold = 100;

struct EditReport {
  std::uint64_t messages = 0;        ///< number of messages written
  std::uint64_t left_out = 0;        ///< number of duplicates that merge() left out; 0 from cut()
  std::vector<std::string> damages;  ///< places that could not be read, at most kMostDamagesTold
};

/// Writes the messages on options.topics in [options.from, options.to) to `out`, with all metadata and attachments.
/// `out` begins with the messages that a player needs at options.from, taken from the 10 s before: the last message of
/// each latched topic (such as camera model and status), and the depth images since the last key frame. The key frame
/// may be older if the file marks key frames. The last message of /station/inside may be older, too; options.from then
/// replaces its time. Error: there is nothing to write, or
/// a file cannot be read or written.
[[nodiscard]] Result<EditReport> cut(const std::filesystem::path& file, const std::filesystem::path& out,
                                     const CutOptions& options);

}  // namespace telepalp::record
