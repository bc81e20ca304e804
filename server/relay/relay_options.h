#pragma once

#include <optional>

#include "server/relay/relay_address.h"
#include "support/program/options.h"

namespace telepalp::relay {

/// What a server's command line says of a cluster.
struct RelayOptions {
  std::optional<RelayAddress> publishes;  ///< to this cluster; nullopt: it does not
  std::optional<RelayAddress> shows;      ///< what another server publishes there: an edge; nullopt: no edge
};

/// Reads `--publish`, and `--source`, if it names a cluster.
[[nodiscard]] Result<RelayOptions> relay_options_of(const program::Arguments& arguments);

}  // namespace telepalp::relay
