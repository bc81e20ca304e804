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

/// Copies all bytes of a complete session between the disk and a cluster, and encrypts or decrypts them: the copy has
/// exactly its messages. Returns the session's size, decrypted. Error: the session is not complete, or `out` exists. Error
/// in a cluster: the session states no consent, or its consent has ended.
[[nodiscard]] Result<std::uint64_t> copy_whole(const std::filesystem::path& session, const std::filesystem::path& out,
                                               const WholeCopyOptions& options);

}  // namespace telepalp::record
