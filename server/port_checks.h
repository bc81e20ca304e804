#pragma once

#include <boost/asio/io_context.hpp>

#include "server/command_line.h"
#include "server/finding.h"

namespace telepalp::server {

/// Listens on all ports of `asked` at the same time, for a moment. So a port is also reported if two options name it.
[[nodiscard]] Findings check_ports(boost::asio::io_context& io, const Asked& asked);

/// Connects to the meeting point and to the clusters of NATS servers that `asked` names. Waits some seconds for each.
[[nodiscard]] Findings check_others(boost::asio::io_context& io, const Asked& asked);

}  // namespace telepalp::server
