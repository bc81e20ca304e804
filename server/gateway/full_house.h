#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace telepalp::gateway {

/// Replies to a new connection with HTTP status 503 and `reason`, and closes it within 0.5 s. At most 16 replies are
/// pending; further sockets are closed without a reply.
void refuse_full_house(boost::asio::ip::tcp::socket socket, const std::string& reason);

}  // namespace telepalp::gateway
