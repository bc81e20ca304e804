#include "server/gateway/full_house.h"

#include <boost/asio/write.hpp>
#include <utility>

#include "proto/wire/sockets/tcp_socket.h"

namespace telepalp::gateway {

void refuse_full_house(boost::asio::ip::tcp::socket socket, const std::string& reason) {
  const std::string answer =
      "HTTP/1.1 503 Service Unavailable\r\nContent-Type: text/plain; charset=utf-8\r\n"
      "Retry-After: 5\r\nConnection: close\r\nCache-Control: no-store\r\nContent-Length: " +
      std::to_string(reason.size() + 1) + "\r\n\r\n" + reason + "\n";
  boost::system::error_code ignored;  // the visitor may be gone already
  socket.non_blocking(true, ignored);
  boost::asio::write(socket, boost::asio::buffer(answer), ignored);  // fits into the send buffer of a new connection
  wire::close_gently(std::move(socket));
}

}  // namespace telepalp::gateway
