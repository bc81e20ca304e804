#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace telepalp::server {

/// Answers whoever connects with 503 and `reason`, and closes within half a second. At most 16 such answers are under
/// way; beyond them the socket is closed at once.
void refuse_full_house(boost::asio::ip::tcp::socket socket, const std::string& reason);

}  // namespace telepalp::server
