#pragma once

#include <string>

#include "proto/keys/seal/site_key.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// The key of TELEPALP_SITE_KEYS with this id, with its private part if one of them has it. Error: none has this id.
/// `file`: which is encrypted with it, for the error.
[[nodiscard]] Result<keys::SiteKey> given_site_key(const std::string& id, const std::string& file);

}  // namespace telepalp::wire::mcap
