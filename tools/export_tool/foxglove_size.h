#pragma once

#include <cstdint>
#include <filesystem>

#include "proto/words/result.h"
#include "tools/export_tool/foxglove_messages.h"

namespace telepalp::export_tool {

/// Sizes of the parts of a file in Foxglove's types [B].
struct FoxgloveSize {
  std::uint64_t color = 0;
  std::uint64_t depth = 0;
  std::uint64_t points = 0;
  std::uint64_t station = 0;
  [[nodiscard]] std::uint64_t total() const noexcept { return color + depth + points + station; }
};

/// The sizes that write_foxglove() would write: of colour and station, all messages are compressed; of depth images and
/// clouds, those of four instants. Error: not a session file.
[[nodiscard]] Result<FoxgloveSize> estimated_size(const std::filesystem::path& file, const FoxgloveParts& parts);

}  // namespace telepalp::export_tool
