#include "proto/wire/sockets/udp_socket.h"

#include <netinet/in.h>

#include <boost/asio/error.hpp>
#include <cerrno>

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;

constexpr int kSocketBuffer_B = 4 << 20;  // the kernel may grant less

/// A network that knows no classes ignores or clears it.
void mark(asio::ip::udp::socket& socket, TrafficClass traffic) noexcept {
  const int byte = type_of_service(traffic);
  (void)::setsockopt(socket.native_handle(), IPPROTO_IP, IP_TOS, &byte, sizeof byte);
  (void)::setsockopt(socket.native_handle(), IPPROTO_IPV6, IPV6_TCLASS, &byte, sizeof byte);
}

}  // namespace

boost::system::error_code open_udp(asio::ip::udp::socket& socket, const asio::ip::udp& protocol, TrafficClass traffic) {
  boost::system::error_code failed;
  socket.open(protocol, failed);
  if (failed) return failed;
  boost::system::error_code smaller;
  socket.set_option(asio::socket_base::receive_buffer_size(kSocketBuffer_B), smaller);
  socket.set_option(asio::socket_base::send_buffer_size(kSocketBuffer_B), smaller);
  mark(socket, traffic);
  socket.non_blocking(true, failed);
  return failed;
}

bool is_own_address(asio::io_context& io, const asio::ip::address& address) {
  const asio::ip::udp::endpoint any_port(address, 0);
  asio::ip::udp::socket socket(io);
  boost::system::error_code failed;
  socket.open(any_port.protocol(), failed);
  if (!failed) socket.bind(any_port, failed);
  return failed.value() != EADDRNOTAVAIL;
}

bool is_sent(const boost::system::error_code& code) noexcept {
  return code != asio::error::would_block && code != asio::error::try_again && code != asio::error::no_buffer_space;
}

}  // namespace telepalp::wire
