#include "proto/wire/sockets/tcp_socket.h"

#include <netinet/tcp.h>

#include <array>
#include <atomic>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <sstream>
#include <utility>

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// Enough to keep the wire busy while the next message is fetched from the queue. More would make an image wait behind
/// one that is already late.
constexpr int kUnsentBytes = 32 << 10;
constexpr int kMostClosing = 32;
std::atomic<int> closing = 0;

class GentleClosing : public std::enable_shared_from_this<GentleClosing> {
 public:
  explicit GentleClosing(tcp::socket socket) : socket_(std::move(socket)), deadline_(socket_.get_executor()) {
    ++closing;
  }
  ~GentleClosing() { --closing; }

  void start() {
    error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    deadline_.expires_after(std::chrono::milliseconds(500));
    deadline_.async_wait([self = shared_from_this()](const error_code& cancelled) {
      error_code closed;
      if (!cancelled) self->socket_.close(closed);
    });
    read();
  }

 private:
  void read() {
    socket_.async_read_some(asio::buffer(unread_), [self = shared_from_this()](const error_code& ended, std::size_t) {
      if (ended) return void(self->deadline_.cancel());
      self->read();
    });
  }

  tcp::socket socket_;
  asio::steady_timer deadline_;
  std::array<char, 4096> unread_{};
};

}  // namespace

void tune(tcp::socket& socket) {
  error_code ignored;  // the options make it quicker; without them it still works
  socket.set_option(tcp::no_delay(true), ignored);
  socket.set_option(asio::detail::socket_option::integer<IPPROTO_TCP, TCP_NOTSENT_LOWAT>(kUnsentBytes), ignored);
}

error_code open_acceptor(tcp::acceptor& acceptor, const tcp::endpoint& endpoint) {
  error_code code;
  acceptor.open(endpoint.protocol(), code);
  if (!code) acceptor.set_option(tcp::acceptor::reuse_address(true), code);
  if (!code) acceptor.bind(endpoint, code);
  if (!code) acceptor.listen(tcp::acceptor::max_listen_connections, code);
  return code;
}

std::string peer_address(const tcp::socket& socket) {
  error_code gone;
  std::ostringstream text;
  text << socket.remote_endpoint(gone);
  return text.str();
}

void close_gently(tcp::socket socket) {
  if (closing < kMostClosing)
    std::make_shared<GentleClosing>(std::move(socket))->start();  // shared: owned by its reads
}

}  // namespace telepalp::wire
