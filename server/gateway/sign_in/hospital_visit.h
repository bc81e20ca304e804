#pragma once

#include <boost/asio/ip/address.hpp>
#include <functional>

#include "server/gateway/gateway.h"
#include "server/gateway/http_reply.h"

namespace telepalp::gateway {

/// The browser's way to the hospital's provider (POST /sign-in/hospital) and back (oidc::kBackTarget), of a server with
/// GatewayOptions::hospital. True: `reply` is called once, now or later; until then it keeps `context`. False: the
/// request is for something else. `peer`: the browser's address.
[[nodiscard]] bool answer_hospital(GatewayContext& context, const HttpRequest& request,
                                   const boost::asio::ip::address& peer, const std::function<void(HttpReply)>& reply);

}  // namespace telepalp::gateway
