#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace telepalp::gateway {

/// Replies to a new connection with HTTP status 503 and `reason`, and closes it within 0.5 s.
void refuse_full_house(boost::asio::ip::tcp::socket socket, const std::string& reason);

}  // namespace telepalp::gateway
