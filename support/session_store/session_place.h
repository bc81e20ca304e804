#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::session_store {

/// How a new session is stored in a cluster.
struct StoreTerms {
  /// Until when the patient's consent allows it; the cluster then removes the session by itself. nullopt: there is no
  /// consent that says so, and no session is stored.
  std::optional<std::chrono::hours> kept_for;
};

/// From now on names such as nats://HOST[:PORT]/SITE/SESSION.mcap, or tls://…, are sessions in a cluster, for all
/// readers and writers of session files in this program (wire::mcap::add_place()). Credentials come from the files that
/// TELEPALP_NATS_CREDS and TELEPALP_NATS_CA name, because a session's name is shown to its viewers. Three servers
/// keep a copy of each new session if the cluster has as many. For main().
void use_cluster_sessions(const StoreTerms& terms = {});

/// True for the name of a session in a cluster.
[[nodiscard]] bool is_in_cluster(std::string_view name);

/// Removes a session from its cluster. Error: there is none of this name, or the cluster refuses.
[[nodiscard]] Result<void> remove_session(const std::string& name);

}  // namespace telepalp::session_store
