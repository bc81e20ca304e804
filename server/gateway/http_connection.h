#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "server/gateway/gateway.h"

namespace telepalp::gateway {

/// Serves HTTP requests on `socket` in order, until it closes or an upgrade turns it into a WebSocket.
void start_http_connection(boost::asio::ip::tcp::socket socket, std::shared_ptr<GatewayContext> context);

}  // namespace telepalp::gateway
