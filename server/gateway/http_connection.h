#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "server/gateway/gateway.h"

namespace telepalp::server {

/// Serves HTTP requests on `socket` one after the other until it closes, or becomes a viewer by an upgrade.
void start_http_connection(boost::asio::ip::tcp::socket socket, std::shared_ptr<GatewayContext> context);

}  // namespace telepalp::server
