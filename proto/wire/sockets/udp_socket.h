#pragma once

#include <boost/asio/ip/udp.hpp>
#include <boost/system/error_code.hpp>

namespace telepalp::wire {

/// Opens `socket` in non-blocking mode, and asks for kernel buffers of 4 MiB: enough for a burst of images.
[[nodiscard]] boost::system::error_code open_udp(boost::asio::ip::udp::socket& socket,
                                                 const boost::asio::ip::udp& protocol);

/// False: the socket's buffer is full, and the datagram can be sent again. Any other failure is a lost datagram.
[[nodiscard]] bool is_sent(const boost::system::error_code& code) noexcept;

}  // namespace telepalp::wire
