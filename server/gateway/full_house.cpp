#include "server/gateway/full_house.h"

#include <array>
#include <atomic>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <memory>
#include <utility>

namespace telepalp::gateway {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr int kMostUnderWay = 16;
std::atomic<int> under_way = 0;

/// Continues to read after its reply. To close with unread bytes would send a TCP reset, which may destroy the reply.
class Refusal : public std::enable_shared_from_this<Refusal> {
 public:
  Refusal(tcp::socket socket, const std::string& reason)
      : socket_(std::move(socket)),
        deadline_(socket_.get_executor()),
        answer_(
            "HTTP/1.1 503 Service Unavailable\r\nContent-Type: text/plain; charset=utf-8\r\n"
            "Retry-After: 5\r\nConnection: close\r\nCache-Control: no-store\r\nContent-Length: " +
            std::to_string(reason.size() + 1) + "\r\n\r\n" + reason + "\n") {
    ++under_way;
  }
  ~Refusal() { --under_way; }

  void start() {
    deadline_.expires_after(std::chrono::milliseconds(500));
    deadline_.async_wait([self = shared_from_this()](const error_code& cancelled) {
      error_code ignored;
      if (!cancelled) self->socket_.close(ignored);
    });
    asio::async_write(socket_, asio::buffer(answer_),
                      [self = shared_from_this()](const error_code& failed, std::size_t) {
                        error_code ignored;
                        if (!failed) self->socket_.shutdown(tcp::socket::shutdown_send, ignored);
                        self->read();
                      });
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
  std::string answer_;
  std::array<char, 4096> unread_{};
};

}  // namespace

void refuse_full_house(tcp::socket socket, const std::string& reason) {
  if (under_way >= kMostUnderWay) return;
  std::make_shared<Refusal>(std::move(socket), reason)->start();  // shared: owned by its pending operations
}

}  // namespace telepalp::gateway
