#pragma once

#include <memory>
#include <string>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/byte_sink.h"
#include "proto/words/result.h"
#include "support/session_store/session_place.h"

namespace telepalp::session_store {

/// The bytes of the session `name` in its cluster. An incomplete session ends with its last block, as a recorder leaves
/// it that is killed. Error: there is no such session, or it is no longer kept.
[[nodiscard]] Result<std::unique_ptr<wire::mcap::ByteSource>> open_stored(const std::string& name);

/// A new session `name` in its cluster. While the cluster loses a server, writing waits and loses nothing. Error: it
/// exists, or `terms` have no consent.
[[nodiscard]] Result<std::unique_ptr<wire::mcap::ByteSink>> create_stored(const std::string& name,
                                                                          const StoreTerms& terms);

}  // namespace telepalp::session_store
