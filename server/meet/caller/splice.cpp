#include "server/meet/caller/splice.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <memory>
#include <utility>

#include "proto/wire/sockets/tcp_socket.h"

namespace telepalp::meet {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

/// Small, because an image that waits here gets older, and no newer image can replace it.
constexpr std::size_t kBuffer = std::size_t{16} * 1024;

class Splice : public std::enable_shared_from_this<Splice> {
 public:
  Splice(tcp::socket caller, std::string first, tcp::socket site, std::function<void()> on_end)
      : first_(std::move(first)), up_{std::move(caller)}, down_{std::move(site)}, on_end_(std::move(on_end)) {}
  ~Splice() { on_end_(); }
  Splice(const Splice&) = delete;
  Splice& operator=(const Splice&) = delete;

  void start() {
    wire::tune(up_.socket);
    wire::tune(down_.socket);
    boost::asio::async_write(down_.socket, boost::asio::buffer(first_),
                             [self = shared_from_this()](const error_code& failed, std::size_t) {
                               if (failed) return self->close();
                               self->read(self->up_, self->down_);
                             });
    read(down_, up_);
  }

  void close() {
    error_code ignored;
    up_.socket.close(ignored);
    down_.socket.close(ignored);
  }

 private:
  struct End {
    tcp::socket socket;
    std::array<std::byte, kBuffer> bytes{};  // read from this end, on their way to the other
  };

  void read(End& from, End& to) {
    from.socket.async_read_some(boost::asio::buffer(from.bytes),
                                [self = shared_from_this(), &from, &to](const error_code& failed, std::size_t count) {
                                  error_code ignored;
                                  if (failed == boost::asio::error::eof)
                                    to.socket.shutdown(tcp::socket::shutdown_send, ignored);
                                  else if (failed)
                                    self->close();
                                  else
                                    self->write(from, to, count);
                                });
  }

  void write(End& from, End& to, std::size_t count) {
    boost::asio::async_write(to.socket, boost::asio::buffer(from.bytes, count),
                             [self = shared_from_this(), &from, &to](const error_code& failed, std::size_t) {
                               if (failed) return self->close();
                               self->read(from, to);
                             });
  }

  std::string first_;
  End up_;
  End down_;
  std::function<void()> on_end_;
};

}  // namespace

std::function<void()> splice(tcp::socket caller, std::string first, tcp::socket site, std::function<void()> on_end) {
  const auto pair = std::make_shared<Splice>(std::move(caller), std::move(first), std::move(site), std::move(on_end));
  pair->start();
  return [weak = std::weak_ptr(pair)] {
    if (const std::shared_ptr<Splice> alive = weak.lock()) alive->close();
  };
}

}  // namespace telepalp::meet
