#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <string_view>

#include "server/gateway/gateway.h"
#include "server/gateway/http_reply.h"

namespace telepalp::server {

/// Accepts the WebSocket `upgrade` on `socket` and runs the Foxglove protocol on it, as a subscriber of the hub.
/// `subprotocol`: the negotiated subprotocol.
void start_viewer_connection(boost::asio::ip::tcp::socket socket, const HttpRequest& upgrade,
                             std::string_view subprotocol, const boost::asio::ip::tcp::endpoint& peer,
                             std::shared_ptr<GatewayContext> context);

}  // namespace telepalp::server
