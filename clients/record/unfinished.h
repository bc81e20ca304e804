#pragma once

#include <filesystem>
#include <optional>

#include "clients/record/repair/repair.h"
#include "proto/words/result.h"

namespace telepalp::record {

/// The unfinished recording that `asked` means: NAME.mcap.partial itself, or NAME.mcap.partial for NAME.mcap if only
/// the partial file exists. nullopt: `asked` is not an unfinished recording.
[[nodiscard]] std::optional<std::filesystem::path> unfinished(const std::filesystem::path& asked);

/// Writes the readable messages of NAME.mcap.partial to a complete NAME.mcap. The partial file is removed if only its
/// end was missing, and kept if it was damaged elsewhere. Error, without any change: a recorder is still writing the
/// file, NAME.mcap exists, or the file has no message.
[[nodiscard]] Result<RepairReport> finish(const std::filesystem::path& partial);

/// The result as text: "session.mcap was not completed by its recorder; the file is complete now, with 1234 messages"
[[nodiscard]] std::string in_words(const RepairReport& finished);

}  // namespace telepalp::record
