#pragma once

#include <memory>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// `source` itself, or, if it is an encrypted session, its decrypted bytes. A block that was altered is not readable;
/// a last block that was cut off is missing, so that the session's end is missing. Error: TELEPALP_SITE_KEYS does not
/// name its key, or the header is damaged.
[[nodiscard]] Result<std::unique_ptr<ByteSource>> decrypted(std::unique_ptr<ByteSource> source);

}  // namespace telepalp::wire::mcap
