#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/system/error_code.hpp>
#include <cstdint>

namespace telepalp::wire {

/// A datagram's class of traffic, by which a network may give it a queue of its own (DSCP, RFC 4594).
enum class TrafficClass : std::uint8_t {
  Touch = 46,     ///< EF: the hand's states and the station's, of less than a kilobyte, and reports
  Pictures = 34,  ///< AF41: depth and colour
};

/// The byte of the IP header that names the class: the class takes its upper six bits.
[[nodiscard]] constexpr std::uint8_t type_of_service(TrafficClass traffic) noexcept {
  return static_cast<std::uint8_t>(static_cast<unsigned>(traffic) << 2U);
}

/// Opens `socket` in non-blocking mode, and asks for kernel buffers of 4 MiB: enough for a burst of images.
/// Marks its datagrams with `traffic`.
[[nodiscard]] boost::system::error_code open_udp(boost::asio::ip::udp::socket& socket,
                                                 const boost::asio::ip::udp& protocol, TrafficClass traffic);

/// False: this computer does not have `address`, or no longer.
[[nodiscard]] bool is_own_address(boost::asio::io_context& io, const boost::asio::ip::address& address);

/// False: the socket's buffer is full, and the datagram can be sent again. Any other failure is a lost datagram.
[[nodiscard]] bool is_sent(const boost::system::error_code& code) noexcept;

}  // namespace telepalp::wire
