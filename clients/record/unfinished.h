#pragma once

#include <filesystem>
#include <optional>

#include "clients/record/repair.h"
#include "proto/words/result.h"

namespace telepalp::record {

/// The recording that was never finished, where `asked` names one: NAME.mcap.partial itself, or NAME.mcap when only its
/// partial file exists. nullopt: there is nothing to finish.
[[nodiscard]] std::optional<std::filesystem::path> unfinished(const std::filesystem::path& asked);

/// Makes a whole NAME.mcap of what can be read of NAME.mcap.partial. The partial file is removed when only its end was
/// missing; when it was damaged elsewhere, too, it stays. An error, and nothing is touched, while a recorder still
/// writes it, when NAME.mcap exists or when it holds no message.
[[nodiscard]] Result<RepairReport> finish(const std::filesystem::path& partial);

/// "session.mcap was not finished by its recorder; finished it now, with 1234 messages"
[[nodiscard]] std::string in_words(const RepairReport& finished);

}  // namespace telepalp::record
