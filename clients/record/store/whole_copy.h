#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "proto/wire/mcap/writing/output_file.h"
#include "proto/words/result.h"

namespace telepalp::record {

struct WholeCopyOptions {
  std::optional<std::chrono::days> keep;  ///< in a cluster
  wire::mcap::Protection protection = wire::mcap::Protection::OfSite;
};

/// What became of the notes beside the session.
enum class CopiedNotes {
  None,     ///< there are none
  Copied,   ///< beside the copy, encrypted as it is
  LeftOut,  ///< a cluster keeps none
};

struct WholeCopy {
  std::uint64_t bytes = 0;  ///< of the session, decrypted
  CopiedNotes notes = CopiedNotes::None;
};

/// Copies all bytes of a complete session between the disk and a cluster, and encrypts or decrypts them: the copy has
/// exactly its messages. The notes beside the session become notes beside the copy. Error: the session is not complete,
/// its notes cannot be read, or `out` or notes on it exist. Error in a cluster: the session states no consent, or its
/// consent has ended.
[[nodiscard]] Result<WholeCopy> copy_whole(const std::filesystem::path& session, const std::filesystem::path& out,
                                           const WholeCopyOptions& options);

}  // namespace telepalp::record
