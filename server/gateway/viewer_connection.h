#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/gateway/gateway.h"
#include "server/gateway/http_reply.h"
#include "server/gateway/sign_in/web_stream.h"
#include "server/gateway/visit.h"

namespace telepalp::gateway {

/// Facts about a viewer, known before its WebSocket opens.
struct Newcomer {
  std::string_view subprotocol;  ///< the negotiated one
  boost::asio::ip::tcp::endpoint peer;
  std::optional<Visitor> visitor;
  std::shared_ptr<origin::Reading> reading;  ///< what this viewer alone sees; null: what the server publishes for all
};

/// Accepts the WebSocket `upgrade` on `stream` and runs the Foxglove protocol on it, as a subscriber of the hub.
void start_viewer_connection(WebStream stream, const HttpRequest& upgrade, const Newcomer& newcomer,
                             std::shared_ptr<GatewayContext> context);

}  // namespace telepalp::gateway
