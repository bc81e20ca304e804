#pragma once

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::record {

enum class Resealed { Changed, HadIt };

/// Lets the first key of TELEPALP_SITE_KEYS decrypt an encrypted session and the notes beside it, instead of the key
/// that did until now, which must be among them with its private part. Only the session's header changes; the notes are
/// written anew, encrypted even if they were not. Error: the session is not encrypted, none of the keys decrypts it or
/// its notes, or the notes are damaged; then the session may have its new key already, and a second call does the rest.
[[nodiscard]] Result<Resealed> reseal(const std::filesystem::path& file);

}  // namespace telepalp::record
