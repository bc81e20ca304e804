#include "proto/wire/sockets/udp_socket.h"

#include <boost/asio/error.hpp>

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;

constexpr int kSocketBuffer_B = 4 << 20;  // the kernel may grant less

}  // namespace

boost::system::error_code open_udp(asio::ip::udp::socket& socket, const asio::ip::udp& protocol) {
  boost::system::error_code failed;
  socket.open(protocol, failed);
  if (failed) return failed;
  boost::system::error_code smaller;
  socket.set_option(asio::socket_base::receive_buffer_size(kSocketBuffer_B), smaller);
  socket.set_option(asio::socket_base::send_buffer_size(kSocketBuffer_B), smaller);
  socket.non_blocking(true, failed);
  return failed;
}

bool is_sent(const boost::system::error_code& code) noexcept {
  return code != asio::error::would_block && code != asio::error::try_again && code != asio::error::no_buffer_space;
}

}  // namespace telepalp::wire
