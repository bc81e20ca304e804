#pragma once

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::record {

enum class Resealed { Changed, HadIt };

/// Lets the first key of TELEPALP_SITE_KEYS decrypt an encrypted session, instead of the key that did until now, which
/// must be among them with its private part. Only the file's header changes. Error: the file is not encrypted, or none
/// of the keys decrypts it.
[[nodiscard]] Result<Resealed> reseal(const std::filesystem::path& file);

}  // namespace telepalp::record
