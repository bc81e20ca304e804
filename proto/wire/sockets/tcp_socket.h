#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace telepalp::wire {

/// Turns Nagle's algorithm off, and bounds the unsent bytes in the kernel to 32 KiB: a message that waits in the
/// kernel cannot be replaced by a newer one.
void tune(boost::asio::ip::tcp::socket& socket);

/// Opens `acceptor` at `endpoint`, also while connections of a server that has just ended are in TIME_WAIT. On Linux
/// this does not let two programs listen at one port.
[[nodiscard]] boost::system::error_code open_acceptor(boost::asio::ip::tcp::acceptor& acceptor,
                                                      const boost::asio::ip::tcp::endpoint& endpoint);

/// "127.0.0.1:4711", or "[::1]:4711": the peer's address.
[[nodiscard]] std::string peer_address(const boost::asio::ip::tcp::socket& socket);

/// Ends the sending direction and reads on for half a second at most: closing a socket with unread bytes sends a reset,
/// which may overtake the last message. At most 32 sockets wait in this way; further ones are closed at once.
void close_gently(boost::asio::ip::tcp::socket socket);

}  // namespace telepalp::wire
