#include "support/session_store/session_place.h"

#include "proto/wire/mcap/format/place.h"
#include "support/nats/nats_address.h"
#include "support/session_store/stored_blocks.h"
#include "support/session_store/stored_session.h"

namespace telepalp::session_store {

void use_cluster_sessions(const StoreTerms& terms) {
  for (const char* beginning : {"nats://", "tls://"})
    wire::mcap::add_place({.beginning = beginning, .open = open_stored, .create = [terms](const std::string& name) {
                             return create_stored(name, terms);
                           }});
}

bool is_in_cluster(std::string_view name) { return nats::is_address(name); }

Result<void> remove_session(const std::string& name) {
  const Result<SessionName> read = parse_name(name);
  if (!read) return read.error();
  Result<std::unique_ptr<StoredBlocks>> blocks = StoredBlocks::connect(*read);
  if (!blocks) return blocks.error();
  return (*blocks)->remove();
}

}  // namespace telepalp::session_store
