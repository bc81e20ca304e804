#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <string>

#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/origin/origin.h"
#include "server/relay/relay_address.h"
#include "support/nats/nats_connection.h"

namespace telepalp::relay {

/// A site that another server publishes to a cluster (Publisher), as an edge sees it: the origin of its messages, and
/// its session clock.
struct Upstream {
  std::unique_ptr<origin::Origin> origin;
  wire::SessionClock clock;  ///< the site's, as estimated when the connection was made
  Nanoseconds clock_error;   ///< bound on its error then: half the quickest round trip
};

struct UpstreamOptions {
  RelayAddress address;
  std::function<void(const std::string&)> log = [](const std::string&) {};
};

/// Connects to the cluster and asks the site for its time. Error: the cluster cannot be reached, or no server publishes
/// the site.
[[nodiscard]] Result<Upstream> connect_upstream(boost::asio::io_context& io, const UpstreamOptions& options);

}  // namespace telepalp::relay
