#pragma once

#include <boost/asio/io_context.hpp>

#include "server/command_line.h"
#include "server/finding.h"

namespace telepalp::server {

/// Listens on each port of `asked` for a moment: all at once, so that a port that two options name is found.
[[nodiscard]] Findings check_ports(boost::asio::io_context& io, const Asked& asked);

/// Connects to the meeting point and to the cluster of NATS servers that `asked` names, within a few seconds each.
[[nodiscard]] Findings check_others(boost::asio::io_context& io, const Asked& asked);

}  // namespace telepalp::server
